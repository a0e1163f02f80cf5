#include "rubsweep/analysis/branch/families/outline.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rubsweep::branch::families {
namespace {

sweep::Grid grid() {
  sweep::Grid grid;
  grid.speed_hz = {10, 20, 30, 40};
  grid.unbalance = {0.1, 0.2, 0.3};
  return grid;
}

/// A family in these cells, which ends halfway to every other cell, to the right by a fold and else by a
/// doubling.
Family family_in(const std::vector<std::size_t>& cells) {
  Family family;
  family.seed = cells.front();
  for (const std::size_t cell : cells) family.orbits[cell] = {};
  for (const std::size_t cell : cells) {
    for (const std::size_t next : neighbours_of(grid(), cell)) {
      if (family.orbits.contains(next)) continue;
      const auto at = [](std::size_t i) {
        return std::pair(grid().speed_hz[i % 4], grid().unbalance[i / 4]);
      };
      const auto [x1, y1] = at(cell);
      const auto [x2, y2] = at(next);
      family.ends.push_back(
          {cell, next, (x1 + x2) / 2, (y1 + y2) / 2, next == cell + 1 ? "fold" : "doubling"});
    }
  }
  return family;
}

TEST(OutlineNeighbours, AtCornersAndInside) {
  EXPECT_EQ(neighbours_of(grid(), 0), (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(neighbours_of(grid(), 5), (std::vector<std::size_t>{4, 6, 1, 9}));
  EXPECT_EQ(neighbours_of(grid(), 11), (std::vector<std::size_t>{10, 7}));
}

/// Closed around one inner cell, and parted where the kind changes.
TEST(Outline, AroundOneCell) {
  const auto lines = outline_of(grid(), family_in({5}));
  for (const OutlineLine& line : lines) EXPECT_TRUE(line.kind == "fold" || line.kind == "doubling");
  ASSERT_EQ(lines.size(), 3u);  // below; right; above, left and below again
  EXPECT_EQ(lines[1].kind, "fold");
  EXPECT_EQ(lines[1].points.back(), (std::array{25.0, 0.2}));
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    EXPECT_EQ(lines[i].points.back(), lines[i + 1].points.front());
  EXPECT_EQ(lines.front().points.front(), lines.back().points.back());
}

/// A family at the end of the map has no boundary there: one open line.
TEST(Outline, EndsWhereTheMapDoes) {
  const auto lines = outline_of(grid(), family_in({0, 1, 4, 5, 8, 9}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].kind, "fold");
  EXPECT_EQ(lines[0].points, (std::vector<std::array<double, 2>>{{25, 0.1}, {25, 0.2}, {25, 0.3}}));
}

TEST(Outline, NoneAroundTheWholeMap) {
  EXPECT_TRUE(outline_of(grid(), family_in({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})).empty());
}

/// Two cells that meet in a corner only: every end is on exactly one line.
TEST(Outline, CellsThatMeetInACorner) {
  const Family family = family_in({0, 5});
  std::size_t ends = 0;
  for (const OutlineLine& line : outline_of(grid(), family)) {
    ASSERT_GE(line.points.size(), 1u);
    ends += line.points.size();
  }
  EXPECT_GE(ends, family.ends.size());
}

}  // namespace
}  // namespace rubsweep::branch::families
