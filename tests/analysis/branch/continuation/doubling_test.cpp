#include "rubsweep/analysis/branch/continuation/doubling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/branch/continuation/plain_maps.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// The two-cycle of the logistic map is born at 3, has the multiplier 4 + 2 r - r^2 and doubles at 1 +
/// sqrt(6).
TEST(DoublingDoubledStart, TheTwoCycleOfTheLogisticMap) {
  const orbits::OrbitProblem single = test::logistic(1, 2, 3.2), doubled = test::logistic(2, 2, 3.6);
  const auto start = orbit_from(single, test::number(0.6), 2.5);
  ASSERT_TRUE(start);
  const HalfBranch branch = follow(single, *start, {});
  ASSERT_EQ(branch.events.size(), 1u);
  const auto beside = doubled_start(doubled, branch.events[0].point);
  ASSERT_TRUE(beside);
  EXPECT_GT(beside->parameter, 3);
  const HalfBranch cycle = follow(doubled, *beside, {});
  ASSERT_EQ(cycle.events.size(), 1u);
  EXPECT_EQ(cycle.events[0].kind, EventKind::period_doubling);
  EXPECT_NEAR(cycle.events[0].point.parameter, 1 + std::sqrt(6), 1e-10);
  for (const BranchPoint& point : cycle.points) {
    const double r = point.parameter;
    EXPECT_NEAR(point.multipliers(0).real(), 4 + 2 * r - r * r, 1e-8);
  }
}

}  // namespace
}  // namespace rubsweep::branch::continuation
