#include "rubsweep/core/response/proof/approach.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

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

TEST(Approach, IsThreeTimesWhatIsPromisedBehindAStart) {
  const Patience patience{.start = 10, .most = 100};
  EXPECT_EQ(patience.turns(0), 10);
  EXPECT_EQ(patience.turns(7), 31);
  EXPECT_EQ(patience.turns(1000), 100);
}

TEST(Approach, IsWorthWhatTheTransientHasGained) {
  const Patience patience{.start = 10, .most = 100};
  EXPECT_NEAR(patience.turns(0.9, 1, std::pow(0.9, 7)), 31, 1e-9);
  EXPECT_EQ(patience.turns(0.9, 1, 1), 10);
  EXPECT_EQ(patience.turns(0.9, 1, 2), 10);
  EXPECT_EQ(patience.turns(0.9, 1, 0), 100);
}

TEST(Approach, AsksForReturnsInARowAndForHalfTheDistance) {
  LinearConvergenceTest convergence(3);
  convergence.add_prediction(0, 1, 0.9);
  convergence.add_prediction(0.009, 1, 0.9);
  EXPECT_FALSE(convergence.passed(0.1, 1));
  convergence.add_prediction(0.011, 1, 0.9);  // more than a tenth of the tenth that a return gains
  convergence.add_prediction(0, 1, 0.9);
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_FALSE(convergence.passed(0.1, 1));
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_TRUE(convergence.passed(0.49, 1));
  EXPECT_FALSE(convergence.passed(0.51, 1));
}

/// The slow direction of an orbit beside a fold, x' = c x - a x^2: the unstable orbit is at -(1 - c) / a.
/// Follows it from `x`; after how many returns, of `most`, the test is passed, and what is left then.
struct Fold {
  double contraction = 0.995, bend = 1;

  std::pair<int, double> follow(double x, int most) const {
    LinearConvergenceTest convergence(3);
    const double first = std::abs(x);
    for (int k = 1; k <= most; ++k) {
      const double next = contraction * x - bend * x * x;
      convergence.add_prediction(std::abs(next - contraction * x), std::abs(x), contraction);
      convergence.add_contraction(std::abs(x), std::abs(next), contraction);
      x = next;
      if (convergence.passed(std::abs(x), first)) return {k, std::abs(x)};
    }
    return {most, std::abs(x)};
  }
};

TEST(Approach, BesideAFoldAGainThatLastsIsEnough) {
  const Fold fold;
  // From the side that the orbit draws from, long before a tenth of the gain is predicted (below 5e-4).
  const auto [returns, left] = fold.follow(0.1, 2000);
  EXPECT_GT(left, 1e-3);
  EXPECT_GE(returns, 138);  // ln 2 / 0.005
  EXPECT_LT(returns, 145);
  // From just before the unstable orbit the gain comes late, and so does the word.
  const auto [later, nearer] = fold.follow(-0.0049, 4000);
  EXPECT_GT(later, 400);
  EXPECT_LT(nearer, 5.1e-4);
  // And never from behind it.
  EXPECT_EQ(fold.follow(-0.0051, 600).first, 600);
}

/// Beside a torus bifurcation, z' = z (c + b |z|^2) e^{i (w + t |z|^2)}: the unstable torus is at |z|^2 =
/// (1 - c) / b, and with the distance changes the angle by which a return turns.
struct Spiral {
  double contraction = 0.995, bend = 0.5, twist = 3;

  /// Follows `most` returns from |z| = `distance`; how many are predicted, and after how many the approach
  /// is.
  std::pair<int, int> follow(double distance, int most) const {
    LinearConvergenceTest convergence(3);
    int predicted = 0;
    std::complex<double> z = distance;
    for (int k = 1; k <= most; ++k) {
      const double square = std::norm(z);
      const auto says = contraction * std::polar(1.0, 1.3) * z;
      const auto next = z * (contraction + bend * square) * std::polar(1.0, 1.3 + twist * square);
      const double error = std::abs(next - says);
      if (error <= 0.1 * (1 - contraction) * std::abs(z)) ++predicted;
      convergence.add_prediction(error, std::abs(z), contraction);
      convergence.add_contraction(std::abs(z), std::abs(next), contraction);
      z = next;
      if (convergence.passed(std::abs(z), distance)) return {predicted, k};
    }
    return {predicted, most};
  }
};

TEST(Approach, BesideATorusBifurcationATurnedApproachIsOne) {
  const auto [predicted, returns] = Spiral{}.follow(0.06, 2000);
  EXPECT_EQ(predicted, 0);
  EXPECT_GT(returns, 138);
  EXPECT_LT(returns, 500);
  // The torus is at 0.1: nothing comes from behind it.
  EXPECT_EQ(Spiral{}.follow(0.101, 2000), std::pair(0, 2000));
}

}  // namespace
}  // namespace rubsweep::response::proof
