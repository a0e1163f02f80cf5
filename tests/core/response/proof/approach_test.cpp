#include "rubsweep/core/response/proof/approach.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <utility>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;

double size_in(const MatrixXd& from, const MatrixXd& turn, const MatrixXd& to) {
  const MatrixXd map = to * turn * from.inverse();
  return numerics::spectral::singular_values(map).values(0);
}

/// A slowly decaying focus: its rotation alone can halve the maximum norm of a disturbance.
TEST(ApproachAdaptedNorms, ContractWhereTheMaximumNormOnlyTurns) {
  const double shrink = 0.999, angle = 0.7, stretch = 20;
  Matrix2d turn;
  turn << std::cos(angle), -stretch * std::sin(angle), std::sin(angle) / stretch, std::cos(angle);
  turn *= shrink;
  EXPECT_GT(turn.cwiseAbs().rowwise().sum().maxCoeff(), 1);
  const auto norms = adapted_norms({turn});
  ASSERT_TRUE(norms);
  EXPECT_NEAR(norms->contraction, (1 + shrink) / 2, 1e-12);
  EXPECT_LE(size_in(norms->norm[0], turn, norms->norm[0]), norms->contraction * (1 + 1e-9));
}

TEST(ApproachAdaptedNorms, EveryTurnOfAPeriodContracts) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<MatrixXd> turns(3, MatrixXd(6, 6));
    MatrixXd monodromy = MatrixXd::Identity(6, 6);
    for (MatrixXd& turn : turns) {
      for (double& x : turn.reshaped()) x = normal(random);
      monodromy = turn * monodromy;
    }
    const double wanted = std::uniform_real_distribution(0.1, 0.9999)(random);
    const double factor = std::cbrt(wanted / numerics::dense::spectral_radius(monodromy));
    for (MatrixXd& turn : turns) turn *= factor;
    const auto norms = adapted_norms(turns);
    ASSERT_TRUE(norms);
    EXPECT_LT(norms->contraction, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const MatrixXd& here = norms->norm[k];
      EXPECT_LE(size_in(here, turns[k], norms->norm[(k + 1) % 3]), norms->contraction * (1 + 1e-7));
      EXPECT_GE(numerics::spectral::singular_values(here).values.minCoeff(), 1 - 1e-9);
    }
  }
}

TEST(ApproachAdaptedNorms, NoneOnTheUnitCircleOrOutside) {
  EXPECT_FALSE(adapted_norms({MatrixXd::Identity(2, 2)}));
  EXPECT_FALSE(adapted_norms({2 * MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2)}));
  EXPECT_TRUE(adapted_norms({2 * MatrixXd::Identity(2, 2), 0.4 * MatrixXd::Identity(2, 2)}));
}

using Eigen::VectorXd;

/// Linear maps of a section of six numbers, of which contacts depend on the first two only. The last two are
/// a slow focus, driven by the others; the middle two decay at once.
struct Turns {
  std::vector<MatrixXd> list;
  MatrixXd seen = MatrixXd::Zero(2, 6);

  explicit Turns(double shrinks) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 3; ++k) {
      MatrixXd turn = MatrixXd::Zero(6, 6);
      for (double& x : turn.leftCols(4).reshaped()) x = 0.2 * normal(random);
      const double angle = 0.7 + k;
      turn.bottomRightCorner(2, 2) << std::cos(angle), -3 * std::sin(angle), std::sin(angle) / 3,
          std::cos(angle);
      turn.rightCols(2) *= shrinks;
      list.push_back(turn);
    }
    seen(0, 0) = seen(1, 1) = 1;
  }
};

/// Spectral norm, from the largest eigenvalue of matrix^T matrix.
double largest(const MatrixXd& matrix) {
  return std::sqrt(numerics::dense::self_adjoint_eigenvalues(matrix.transpose() * matrix).maxCoeff());
}

TEST(ApproachSplitNorms, AVibrationThatNoContactSeesIsTheSlowPart) {
  const Turns turns(0.98);
  const auto norms = split_norms(turns.list, turns.seen);
  ASSERT_TRUE(norms);
  EXPECT_EQ(norms->fast, 4);
  EXPECT_EQ(norms->slow(), 2);
  EXPECT_NEAR(norms->contraction.slow, std::cbrt((1 + std::pow(0.98, 3)) / 2), 1e-9);
  EXPECT_LT(norms->contraction.fast, 0.9);
  VectorXd offset = VectorXd::Zero(6);
  offset.tail(2) << 0.3, -0.1;
  EXPECT_NEAR(parts_of(*norms, 1, offset).fast, 0, 1e-12);
  EXPECT_GT(parts_of(*norms, 1, offset).slow, 0.1);
}

TEST(ApproachSplitNorms, EveryTurnDrawsBothPartsTogether) {
  const Turns turns(0.98);
  const auto norms = split_norms(turns.list, turns.seen);
  ASSERT_TRUE(norms);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE((norms->norm[k] * norms->unit[k] - MatrixXd::Identity(6, 6)).norm(), 1e-10);
    const MatrixXd turn = norms->norm[(k + 1) % 3] * turns.list[k] * norms->unit[k];
    EXPECT_LE(largest(turn.topLeftCorner(4, 4)), norms->contraction.fast * (1 + 1e-9));
    EXPECT_LE(largest(turn.bottomRightCorner(2, 2)), norms->contraction.slow * (1 + 1e-9));
    // Contacts do not depend on the slow part, so it drives nothing.
    EXPECT_LE(largest(turn.topRightCorner(4, 2)), 1e-10);
  }
}

TEST(ApproachSplitNorms, NoneWhereContactsSeeEverything) {
  const Turns turns(0.98);
  MatrixXd seen = turns.seen;
  seen(0, 4) = 1e-3;
  EXPECT_FALSE(split_norms(turns.list, seen));
}

TEST(ApproachSplitNorms, NoneWhereTheUnseenVibrationDecaysAtOnceOrGrows) {
  const Turns fast(0.3), growing(1.01);
  EXPECT_FALSE(split_norms(fast.list, fast.seen));
  EXPECT_FALSE(split_norms(growing.list, growing.seen));
}

/// For one wall on the upper side, the penetration is y of the rotor minus y of the casing.
TEST(ApproachSeenByContacts, PenetrationsAndTheirRates) {
  const MatrixXd rows = seen_by_contacts(test::cell_of({}).scene);
  ASSERT_EQ(rows.rows(), 2);
  ASSERT_EQ(rows.cols(), 8);
  MatrixXd wanted = MatrixXd::Zero(2, 8);
  wanted(0, 1) = wanted(1, 5) = 1;
  wanted(0, 3) = wanted(1, 7) = -1;
  EXPECT_LE((rows - wanted).norm(), 1e-12);
}

constexpr double shrinks = 0.98;

/// A spiral into the origin with an edge at x = -0.03, beyond which it leads far away.
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

/// The distance in x halves after one sixth of a rotation, while the spiral shrinks by only 2 %.
TEST(ApproachComesNear, ATransientThatMeetsAnEdgeLaterDoesNot) {
  const std::array<double, 2> far{0.04, 0};
  const Found at = orbit_near(far);
  EXPECT_FALSE(comes_near(spiral, far, at.orbit, at.norms, {1e-6, 0}, no_end));
  EXPECT_FALSE(comes_near(spiral, far, at.orbit, at.norms, {1e-6, 0, true}, no_end));
}

/// The spiral is linear, so half of the distance confirms the prediction.
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

/// It tries for three times as long as the norm predicts, plus a minimum number of turns.
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

/// Two decays with different rates in separate norms: the slower one decides, unless its ball is large.
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
  convergence.add_prediction(0.011, 1, 0.9);  // more than 10 % of the 10 % that a return gains
  convergence.add_prediction(0, 1, 0.9);
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_FALSE(convergence.passed(0.1, 1));
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_TRUE(convergence.passed(0.49, 1));
  EXPECT_FALSE(convergence.passed(0.51, 1));
}

/// Slow direction of an orbit near a fold, x' = c x - a x^2, with an unstable orbit at -(1 - c) / a. `follow`
/// starts at `x`. It returns the number of turns of the map until the test passes (at most `most`), and the
/// distance at that time.
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
  // On the attracting side the test passes long before the error of the prediction falls to 10 % of the gain,
  // which happens at a distance of 5e-4.
  const auto [returns, left] = fold.follow(0.1, 2000);
  EXPECT_GT(left, 1e-3);
  EXPECT_GE(returns, 138);  // ln 2 / 0.005
  EXPECT_LT(returns, 145);
  // Close to the unstable orbit the gain comes late, and the test passes late.
  const auto [later, nearer] = fold.follow(-0.0049, 4000);
  EXPECT_GT(later, 400);
  EXPECT_LT(nearer, 5.1e-4);
  // Beyond the unstable orbit the test never passes.
  EXPECT_EQ(fold.follow(-0.0051, 600).first, 600);
}

/// Near a torus bifurcation, z' = z (c + b |z|^2) e^{i (w + t |z|^2)}: the unstable torus is at |z|^2 = (1 -
/// c) / b, and the rotation angle per return depends on the distance.
struct Spiral {
  double contraction = 0.995, bend = 0.5, twist = 3;

  /// Follows up to `most` returns from |z| = `distance`. Returns how many were predicted, and after how many
  /// the test passed.
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
  // The torus is at |z| = 0.1: the test never passes beyond it.
  EXPECT_EQ(Spiral{}.follow(0.101, 2000), std::pair(0, 2000));
}

}  // namespace

}  // namespace rubsweep::response::proof
