#include "rubsweep/branch/growing_half.hpp"

#include <gtest/gtest.h>

#include "rubsweep/branch/follow.hpp"

namespace rubsweep::branch {
namespace {

constexpr double straight = 1, gentle = 0.96, sharp = 0.9;

FollowOptions options() {
  FollowOptions options;
  options.first_step = 0.1;
  options.longest_step = 0.2;
  options.shortest_step = 1e-3;
  options.most_points = 4;
  return options;
}

TEST(GrowingHalf, StepsGrowWhereItIsEasyAndShrinkToTheEnd) {
  GrowingHalf<HalfBranch> side(BranchPoint{}, options());
  side.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(side.step(), 0.15);
  side.lengthen(straight, false);
  side.lengthen(gentle, true);
  EXPECT_DOUBLE_EQ(side.step(), 0.15);
  side.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(side.step(), 0.2) << "the longest";
  EXPECT_TRUE(side.turns_sharply(sharp));
  EXPECT_FALSE(side.turns_sharply(gentle));
  EXPECT_TRUE(side.is_far(0.05));
  EXPECT_FALSE(side.is_far(0.03));
  int halves = 0;
  side.grow([&] {
    side.shorten(Ending::failed);
    ++halves;
  });
  EXPECT_EQ(halves, 8) << "0.2 / 2^8 is the first one below 1e-3";
  EXPECT_EQ(side.half.ending, Ending::failed);
  EXPECT_FALSE(side.turns_sharply(sharp)) << "so near, a corner is gone round";
}

TEST(GrowingHalf, EndsAtTheLimitOfPoints) {
  GrowingHalf<HalfBranch> side(BranchPoint{}, options());
  side.grow([&] { side.half.points.push_back(side.here()); });
  EXPECT_EQ(side.half.points.size(), 4u);
  EXPECT_EQ(side.half.ending, Ending::point_limit);
}

TEST(GrowingHalf, BothSidesAsOne) {
  std::vector<BranchPoint> backward(2), forward(2);
  backward[0].arclength = 1;
  backward[1].arclength = 2;
  forward[1].arclength = 3;
  turn_about(backward, [](BranchPoint& point) -> BranchPoint& { return point; });
  std::vector<double> arclengths;
  for (const BranchPoint& point : joined(backward, forward)) arclengths.push_back(point.arclength);
  EXPECT_EQ(arclengths, (std::vector<double>{-2, -1, 0, 3}));
}

}  // namespace
}  // namespace rubsweep::branch
