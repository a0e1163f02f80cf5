#include "rubsweep/response/proof/approach.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace rubsweep::response::proof {
namespace {

constexpr double shrinks = 0.98;

/// A spiral into the origin, with an edge in its way, below x = -0.03, that leads far away.
bool spiral(std::span<double> s, Eigen::MatrixXd* disturbances) {
  constexpr double angle = std::numbers::pi / 3;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  turn *= shrinks;
  if (disturbances) *disturbances = turn * *disturbances;
  const Eigen::Vector2d next = turn * Eigen::Vector2d(s[0], s[1]);
  s[0] = next.x() < -0.03 ? 5 : next.x();
  s[1] = next.y();
  return true;
}

struct Found {
  StableOrbit orbit;
  AdaptedNorms norms;
};

Found orbit_near(std::span<const double> section) {
  const auto orbit = find_orbit(spiral, section, 1);
  EXPECT_TRUE(orbit);
  return {*orbit, *adapted_norms(orbit->transitions)};
}

constexpr Patience no_end{.start = 10'000, .most = 10'000};

Patience turns(double most) { return {.start = most, .most = most}; }

TEST(ApproachComesNear, FollowsAllTheWay) {
  const std::array<double, 2> near{0.02, 0};
  const Found at = orbit_near(near);
  const double distance = adapted_distance(near, at.orbit, at.norms);
  EXPECT_TRUE(comes_near(spiral, near, at.orbit, at.norms, {1e-4 * distance, 0}, no_end));
  const double needed = std::ceil(std::log(1e-4) / std::log(shrinks));
  EXPECT_TRUE(comes_near(spiral, near, at.orbit, at.norms, {1e-4 * distance, 0}, turns(needed + 1)));
  EXPECT_FALSE(comes_near(spiral, near, at.orbit, at.norms, {1e-4 * distance, 0}, turns(needed - 2)));
}

/// The distance in x halves after one sixth of a rotation, in which the spiral has shrunk by 2 %.
TEST(ApproachComesNear, ATransientThatMeetsAnEdgeLaterDoesNot) {
  const std::array<double, 2> far{0.04, 0};
  const Found at = orbit_near(far);
  EXPECT_FALSE(comes_near(spiral, far, at.orbit, at.norms, {1e-6, 0}, no_end));
  EXPECT_FALSE(comes_near(spiral, far, at.orbit, at.norms, {1e-6, 0, true}, no_end));
}

/// The spiral is linear, so that half of the distance is enough.
TEST(ApproachComesNear, HalfWayIsEnoughWhereItIsForetold) {
  const std::array<double, 2> near{0.02, 0};
  const Found at = orbit_near(near);
  const double half = std::ceil(std::log(0.5) / std::log(shrinks));
  EXPECT_TRUE(comes_near(spiral, near, at.orbit, at.norms, {1e-6, 0, true}, turns(half + 1)));
  EXPECT_FALSE(comes_near(spiral, near, at.orbit, at.norms, {1e-6, 0, true}, turns(half - 2)));
  EXPECT_FALSE(comes_near(spiral, near, at.orbit, at.norms, {1e-6, 0, false}, turns(half + 1)));
  StableOrbit other = at.orbit;
  other.transitions.front() *= 0.9;
  EXPECT_FALSE(comes_near(spiral, near, other, at.norms, {1e-6, 0, true}, turns(half + 1)));
}

/// Three times as long as the norm promises, and a start.
TEST(ApproachComesNear, GivesUpWhatComesNoNearer) {
  const std::array<double, 2> near{0.02, 0};
  const Found at = orbit_near(near);
  long made = 0;
  const TurnMap standing = [&made](std::span<double>, Eigen::MatrixXd*) {
    ++made;
    return true;
  };
  EXPECT_FALSE(comes_near(standing, near, at.orbit, at.norms, {1e-6, 0, true}, {.start = 64, .most = 1e6}));
  EXPECT_EQ(made, 64);
}

/// Two decays at different rates, in norms apart: the slower one decides, unless its ball is large.
TEST(ApproachComesInside, EitherPartMustBeInItsBall) {
  const TurnMap decay = [](std::span<double> s, Eigen::MatrixXd* disturbances) {
    const Eigen::Vector2d factors(0.5, 0.9);
    if (disturbances) *disturbances = factors.asDiagonal() * *disturbances;
    s[0] *= factors(0), s[1] *= factors(1);
    return true;
  };
  const std::array<double, 2> here{0.01, 0.01};
  const auto orbit = find_orbit(decay, here, 1);
  ASSERT_TRUE(orbit);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(2, 2);
  const SplitNorms norms{.norm = {identity}, .unit = {identity}, .fast = 1, .contraction = {0.5, 0.9}};
  EXPECT_TRUE(comes_inside(decay, here, *orbit, norms, {1e-4, 0.02}, 7));
  EXPECT_FALSE(comes_inside(decay, here, *orbit, norms, {1e-4, 0.02}, 6));
  EXPECT_TRUE(comes_inside(decay, here, *orbit, norms, {1e-4, 1e-3}, 22));
  EXPECT_FALSE(comes_inside(decay, here, *orbit, norms, {1e-4, 1e-3}, 21));
  EXPECT_TRUE(comes_inside(decay, here, *orbit, norms, {0.1, 0.1}, 0));
}

TEST(ApproachComesNear, EitherMeasureWillDo) {
  const std::array<double, 2> near{0.02, 0};
  const Found at = orbit_near(near);
  EXPECT_TRUE(comes_near(spiral, near, at.orbit, at.norms, {0, 0.021}, turns(0)));
  EXPECT_FALSE(comes_near(spiral, near, at.orbit, at.norms, {0, 0.019}, turns(0)));
}

}  // namespace
}  // namespace rubsweep::response::proof
