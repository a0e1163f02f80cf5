#include "rubreport/map_table.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

MapTable table_of(const std::string& text) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_map_table(path);
}

TEST(MapTable, ColumnsOfNumbersAndOfWordsAndWhatIsEmpty) {
  const MapTable map = table_of(
      "# rubsweep 9.8.7\n# digest abc\n# units: SI\n"
      "speed_hz,class,order,robust,new_column\n"
      "50,non_contact,,,1.5\n"
      "75,subharmonic,2,,inf\n");
  EXPECT_EQ(map.version, "9.8.7");
  EXPECT_EQ(map.digest, "abc");
  EXPECT_EQ(map.rows, 2u);
  EXPECT_EQ(map.number("speed_hz", 1), 75.0);
  EXPECT_EQ(map.word("class", 0), "non_contact");
  EXPECT_FALSE(map.number("order", 0));
  EXPECT_EQ(map.number("order", 1), 2.0);
  EXPECT_EQ(map.word("robust", 1), "");
  EXPECT_TRUE(map.find("robust")->numbers.empty());
  EXPECT_EQ(map.number("new_column", 0), 1.5);
  EXPECT_FALSE(map.find("nothing"));
  EXPECT_FALSE(map.number("class", 0));
  EXPECT_EQ(map.word("speed_hz", 0), "");
}

TEST(MapTable, AColumnWithOneWordIsOneOfWords) {
  const MapTable map = table_of("status\n1\nok\n2\n");
  EXPECT_EQ(map.word("status", 0), "1");
  EXPECT_EQ(map.word("status", 1), "ok");
  EXPECT_EQ(map.digest, "");
}

TEST(MapTable, ARowCutShortHasItsPlace) {
  EXPECT_THROW(table_of("a,b\n1\n"), IoError);
  EXPECT_THROW(read_map_table("/nowhere/map.csv"), IoError);
}

TEST(MapTable, ItsRowsAreInTheOrderOfTheCellsWhateverThatOfTheFile) {
  const sweep::Grid grid{{50, 60}, sweep::UnbalanceMeasure::whirl_ratio, {0.2, 0.4}};
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  const std::string header = "speed_hz,whirl_ratio,class,revolutions\n";
  std::ofstream(path) << header
                      << "60,0.4,chaotic,4\n50,0.4,unsettled,3\n50,0.2,non_contact,1\n60,0.2,synchronous,2\n";
  const MapTable map = read_map_table(path, grid);
  for (std::size_t cell = 0; cell < 4; ++cell)
    EXPECT_EQ(map.number("revolutions", cell), static_cast<double>(cell + 1));
  EXPECT_EQ(map.word("class", 0), "non_contact");
  EXPECT_EQ(map.word("class", 3), "chaotic");
  EXPECT_EQ(map.cells, (std::vector<std::size_t>{0, 1, 2, 3}));

  std::ofstream(path) << header << "60,0.4,chaotic,4\n50,0.4,unsettled,3\n50,0.2,non_contact,1\n";
  EXPECT_TRUE(message_of<IoError>([&] {
                read_map_table(path, grid);
              }).ends_with("map.csv: holds 3 cells of 4, there is no row of speed_hz 60, whirl_ratio 0.2"));

  sweep::Grid refined = grid;
  refined.refinement = sweep::Refinement{1, 0};
  EXPECT_EQ(read_map_table(path, refined).cells, (std::vector<std::size_t>{0, 2, 3}));
  std::ofstream(path) << header << "61,0.4,chaotic,4\n";
  EXPECT_THROW(read_map_table(path, refined), IoError);
}

TEST(MapTable, ADamagedCellHasItsPlace) {
  const auto problem = [](const std::string& text) { return message_of<IoError>([&] { table_of(text); }); };
  EXPECT_TRUE(
      problem("speed_hz,class\n50,chaotic\n60,foo\n").ends_with("map.csv:3: 'foo' is no class of a motion"));
  EXPECT_NE(problem("speed_hz,peak_displacement_m\n50,1e-3\n60,abc\n").find("map.csv:3: "),
            std::string::npos);
}

std::vector<Boundary> boundaries_of(const std::string& text) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "boundaries.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_boundaries(path, "whirl_ratio", "abc");
}

TEST(MapTableBoundaries, OneLineForEachFamilyAndKind) {
  const auto lines = boundaries_of(
      "# any comment\n"
      "family,kind,point,speed_hz,unbalance,extra\n"
      "a,fold,0,50,0.1,x\na,fold,1,60,0.2,x\na,flip,0,60,0.2,x\nb,flip,0,70,0.3,x\nb,flip,1,,,x\nb,flip,2,80,"
      "0.4,x\n");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].family, "a");
  EXPECT_EQ(lines[0].kind, "fold");
  EXPECT_EQ(lines[0].points, (std::vector<std::array<double, 2>>{{50, 0.1}, {60, 0.2}}));
  EXPECT_EQ(lines[1].kind, "flip");
  EXPECT_EQ(lines[2].family, "b");
  EXPECT_EQ(lines[3].points, (std::vector<std::array<double, 2>>{{80, 0.4}}));
}

TEST(MapTableBoundaries, TheMeasureOfTheMapComesBeforeAnyOther) {
  EXPECT_EQ(boundaries_of("speed_hz,unbalance_m,whirl_ratio\n50,1e-5,0.3\n").at(0).points.at(0)[1], 0.3);
  EXPECT_EQ(boundaries_of("speed_hz,unbalance_m\n50,1e-5\n").at(0).points.at(0)[1], 1e-5);
}

TEST(MapTableBoundaries, OfAnotherMapAreLeftOut) {
  const std::string rows = "speed_hz,unbalance\n50,0.1\n";
  EXPECT_EQ(boundaries_of(rows).size(), 1u);
  EXPECT_EQ(boundaries_of("# digest abc\n" + rows).size(), 1u);
  EXPECT_TRUE(boundaries_of("# digest abd\n" + rows).empty());
}

TEST(MapTableBoundaries, NoFileHasNoLinesAndOneWithoutColumnsIsRefused) {
  EXPECT_TRUE(read_boundaries("/nowhere/boundaries.csv", "whirl_ratio", "").empty());
  EXPECT_THROW(boundaries_of("speed_hz,height\n50,1\n"), IoError);
  EXPECT_THROW(boundaries_of("speed,unbalance\n50,1\n"), IoError);
  EXPECT_THROW(boundaries_of("speed_hz,unbalance\n50,high\n"), IoError);
}

}  // namespace

}  // namespace rubsweep::page
