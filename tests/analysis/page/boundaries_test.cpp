#include "rubsweep/analysis/page/boundaries.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

std::vector<Boundary> boundaries_of(const std::string& text) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "boundaries.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_boundaries(path, "whirl_ratio", "abc");
}

TEST(Boundaries, OneLineForEachFamilyAndKind) {
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

TEST(Boundaries, TheMeasureOfTheMapComesBeforeAnyOther) {
  EXPECT_EQ(boundaries_of("speed_hz,unbalance_m,whirl_ratio\n50,1e-5,0.3\n").at(0).points.at(0)[1], 0.3);
  EXPECT_EQ(boundaries_of("speed_hz,unbalance_m\n50,1e-5\n").at(0).points.at(0)[1], 1e-5);
}

TEST(Boundaries, OfAnotherMapAreLeftOut) {
  const std::string rows = "speed_hz,unbalance\n50,0.1\n";
  EXPECT_EQ(boundaries_of(rows).size(), 1u);
  EXPECT_EQ(boundaries_of("# digest abc\n" + rows).size(), 1u);
  EXPECT_TRUE(boundaries_of("# digest abd\n" + rows).empty());
}

TEST(Boundaries, NoFileHasNoLinesAndOneWithoutColumnsIsRefused) {
  EXPECT_TRUE(read_boundaries("/nowhere/boundaries.csv", "whirl_ratio", "").empty());
  EXPECT_THROW(boundaries_of("speed_hz,height\n50,1\n"), IoError);
  EXPECT_THROW(boundaries_of("speed,unbalance\n50,1\n"), IoError);
  EXPECT_THROW(boundaries_of("speed_hz,unbalance\n50,high\n"), IoError);
}

}  // namespace
}  // namespace rubsweep::page
