#include "rubsweep/maps/report/map_cells.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

class MapCells : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text, const char* name = "map.csv") {
    std::ofstream(directory_.path() / name) << text;
    return directory_.path() / name;
  }

  std::string axis_of(const std::string& a, const std::string& b) {
    const std::string header = "speed_hz,whirl_ratio,eccentricity_m\n";
    return second_axis(write(header + a, "a.csv"), write(header + b, "b.csv"));
  }

 private:
  const TemporaryDirectory directory_;
};

/// Two speeds at two whirl ratios: the eccentricity differs in every cell.
TEST_F(MapCells, TheAxisIsWhatComesAgain) {
  const std::string by_ratio = "50,0.2,1\n60,0.2,2\n50,0.4,3\n60,0.4,4\n",
                    by_eccentricity = "50,1,0.2\n60,2,0.2\n50,3,0.4\n60,4,0.4\n";
  EXPECT_EQ(axis_of(by_ratio, by_ratio), "whirl_ratio");
  EXPECT_EQ(axis_of(by_eccentricity, by_eccentricity), "eccentricity_m");
}

/// At a single speed, both measures have equally many values.
TEST_F(MapCells, TheAxisIsWhatTwoMapsHaveInCommon) {
  EXPECT_EQ(axis_of("50,1,0.2\n50,3,0.4\n", "50,1.1,0.2\n50,3.3,0.4\n"), "eccentricity_m");
  EXPECT_EQ(axis_of("50,0.2,1\n50,0.4,2\n", "50,0.2,1.1\n50,0.4,2.2\n"), "whirl_ratio");
}

/// A rotor that rests on its stop by gravity has no whirl ratio.
TEST_F(MapCells, WhatIsEmptyIsNoAxis) {
  const std::string pressed = "50,,0.2\n60,,0.2\n50,,0.4\n60,,0.4\n";
  EXPECT_EQ(axis_of(pressed, pressed), "eccentricity_m");
  EXPECT_EQ(axis_of("50,0.2,\n60,0.2,2\n", "50,0.2,1\n60,0.2,2\n"), "whirl_ratio");
}

TEST_F(MapCells, ARowThatIsNoCellIsAnError) {
  const auto path = write("speed_hz,whirl_ratio\n50,0.2\n60,\n");
  EXPECT_EQ(message_of<IoError>([&] { rows_by_cell(path, "whirl_ratio", {}); }),
            path.string() + ":3: column 'whirl_ratio' does not say which cell this is, allowed: a number");
}

TEST_F(MapCells, KeysAreThoseOfTheComments) {
  const auto path = write(
      "# digest abc\n# keys kick.force_n,stops.0.clearance_m\nspeed_hz,whirl_ratio,kick.force_n,"
      "stops.0.clearance_m\n60,0.4,20,1e-3\n50,0.4,30,2e-3\n50,0.4,20,1e-3\n");
  batch::CsvReader map(path);
  EXPECT_EQ(comment_after(map, "digest "), "abc");
  EXPECT_EQ(comment_after(map, "units: "), "");
  const auto keys = keys_of(map);
  EXPECT_EQ(keys, (std::vector<std::string>{"kick.force_n", "stops.0.clearance_m"}));
  const auto cells = rows_by_cell(path, "whirl_ratio", keys);
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[0].key, (CellKey{50, 0.4, 20, 1e-3}));
  EXPECT_EQ(cells[2].key, (CellKey{60, 0.4, 20, 1e-3}));
  EXPECT_EQ(find_cell(cells, {50, 0.4, 30, 2e-3}), 1u);
  EXPECT_FALSE(find_cell(cells, {50, 0.4, 30, 1e-3}));
}

TEST_F(MapCells, ACellThatIsThereTwiceIsAnError) {
  const auto path = write("speed_hz,whirl_ratio\n50,0.2\n60,0.2\n50,0.2\n");
  EXPECT_EQ(message_of<IoError>([&] { rows_by_cell(path, "whirl_ratio", {}); }),
            path.string() + ":4: this cell is in the map twice");
}

/// Two descending speeds, three unordered eccentricities, and an axis of two keys, the first of which is
/// constant.
const sweep::Grid grid{{60, 50},
                       sweep::UnbalanceMeasure::eccentricity_m,
                       {1e-5, 3e-5, 2e-5},
                       {{{"kick.angle_deg", "kick.force_n"}, {0, -2}, {100, 300}}}};
const std::string header = "class,kick.force_n,kick.angle_deg,eccentricity_m,speed_hz\n";

std::string row(std::size_t cell) {
  const std::vector<std::string> unbalances{"1e-05", "3e-5", "0.00002"};
  return "chaotic," + std::string(cell < 6 ? "-200" : "-600") + ",0," + unbalances[cell / 2 % 3] + "," +
         (cell % 2 == 0 ? "60" : "50.0") + "\n";
}

/// The cells of a map's rows; with `whole`, all cells must be present.
std::vector<std::size_t> cells_of(const std::string& rows, bool whole = false) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::ofstream(path, std::ios::binary) << "# a comment\n" << header << rows;
  batch::CsvReader map(path);
  CellsOfRows cells(map, grid);
  std::vector<std::size_t> found;
  while (map.next()) found.push_back(cells.take(map));
  EXPECT_EQ(cells.taken(), found.size());
  if (whole) cells.require_all();
  return found;
}

std::string problem(const std::string& rows, bool whole = false) {
  const std::string text = message_of<IoError>([&] { cells_of(rows, whole); });
  return text.substr(text.find("map.csv"));
}

TEST(MapCellsCellsOfRows, ComeFromTheValuesWhateverTheOrder) {
  std::string rows;
  std::vector<std::size_t> shuffled;
  for (std::size_t i = 0; i < 12; ++i) {
    shuffled.push_back(5 * i % 12);
    rows += row(shuffled.back());
  }
  EXPECT_EQ(cells_of(rows, true), shuffled);
}

TEST(MapCellsCellsOfRows, ACellIsThereOnceAtMost) {
  EXPECT_EQ(problem(row(0) + row(7) + row(0)),
            "map.csv:5: the row of speed_hz 60, eccentricity_m 1e-05, kick.angle_deg 0, kick.force_n -200 is "
            "there twice");
}

TEST(MapCellsCellsOfRows, WhatIsNoCellHasItsPlace) {
  const std::string unknown = " is no cell of its configuration";
  EXPECT_EQ(problem("chaotic,-200,0,1e-5,61\n"),
            "map.csv:3: the row of speed_hz 61, eccentricity_m 1e-5, kick.angle_deg 0, kick.force_n -200" +
                unknown);
  EXPECT_EQ(problem("chaotic,-200,1,1e-5,60\n"),
            "map.csv:3: the row of speed_hz 60, eccentricity_m 1e-5, kick.angle_deg 1, kick.force_n -200" +
                unknown);
  EXPECT_EQ(
      problem("chaotic,-200,0,,60\n"),
      "map.csv:3: the row of speed_hz 60, eccentricity_m , kick.angle_deg 0, kick.force_n -200" + unknown);
}

TEST(MapCellsCellsOfRows, AMissingOneIsNamed) {
  std::string rows;
  for (std::size_t cell = 0; cell < 12; ++cell) rows += cell == 9 ? "" : row(cell);
  EXPECT_EQ(problem(rows, true),
            "map.csv: holds 11 cells of 12, there is no row of speed_hz 50, eccentricity_m 3e-05, "
            "kick.angle_deg 0, kick.force_n -600");
}

}  // namespace
}  // namespace rubsweep::report
