#include "rubsweep/analysis/branch/curves/extended_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/branch/curves/plain_planes.hpp"

namespace rubsweep::branch::curves {
namespace {

using Eigen::VectorXd;

/// Two coupled numbers that depend on both parameters; their derivative has no symmetry.
orbits::PlaneOrbits curved_plane() {
  orbits::PlaneOrbits orbits = test::plain_plane(
      [](double p, double q, const VectorXd& x) {
        return VectorXd(Eigen::Vector2d(x(0) + p - x(0) * x(0) + 0.3 * x(1) * q,
                                        -0.9 * x(1) + 0.2 * x(0) * x(1) + q * q * x(0) + 0.1 * p));
      },
      [](double, double q, const VectorXd& x) {
        Eigen::MatrixXd m(2, 2);
        m << 1 - 2 * x(0), 0.3 * q, 0.2 * x(1) + q * q, -0.9 + 0.2 * x(0);
        return m;
      });
  orbits.first = {-1, 3};  // widths other than 1
  orbits.second = {0, 0.5};
  return orbits;
}

TEST(ExtendedSystem, PlacesAndStatesComeBack) {
  const orbits::PlaneOrbits orbits = curved_plane();
  const ExtendedSystem fold{&orbits, continuation::EventKind::fold, 2},
      graze{&orbits, continuation::EventKind::graze, 2};
  const Eigen::Vector2d state(0.3, -0.7);
  const continuation::Position at = position_of(fold, {1, 0.25, 5}, state);
  ASSERT_EQ(at.size(), 4);
  EXPECT_DOUBLE_EQ(at(2), 0.25) << "a share of the range";
  EXPECT_DOUBLE_EQ(at(3), 0.5);
  EXPECT_EQ(place_of(fold, at), (orbits::PlanePoint{1, 0.25, 0})) << "the phase belongs to grazes alone";
  EXPECT_NEAR((state_of(fold, at) - state).norm(), 0, 1e-15);
  EXPECT_EQ(place_of(graze, position_of(graze, {1, 0.25, 5}, state)), (orbits::PlanePoint{1, 0.25, 5}));
}

/// Compares every row of the Jacobian with differences of the residual.
TEST(ExtendedSystem, JacobianOfFoldDoublingAndTorus) {
  const orbits::PlaneOrbits orbits = curved_plane();
  for (const continuation::EventKind kind :
       {continuation::EventKind::fold, continuation::EventKind::period_doubling,
        continuation::EventKind::neimark_sacker}) {
    const ExtendedSystem system{&orbits, kind, 2};
    const continuation::Position at = position_of(system, {0.4, 0.2, 0}, Eigen::Vector2d(0.11, 0.23));
    const Extended extended = extend(system, at);
    ASSERT_EQ(extended.evaluation, orbits::Evaluation::ok);
    ASSERT_EQ(extended.jacobian.rows(), system.unknowns() - 1);
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      constexpr double h = 1e-5;
      continuation::Position above = at, below = at;
      above(k) += h;
      below(k) -= h;
      const VectorXd slope = (extend(system, above).residual - extend(system, below).residual) / (2 * h);
      EXPECT_LT((slope - extended.jacobian.col(k)).cwiseAbs().maxCoeff(), 1e-6)
          << to_string(kind) << ' ' << k;
    }
  }
}

/// The condition of each kind is zero where the multiplier is critical, and nowhere else.
TEST(ExtendedSystem, ConditionsAreZeroWhereTheyShouldBe) {
  const orbits::PlaneOrbits orbits =
      test::plain_plane_of_one_number([](double p, double q, double x) { return (1 + p) * x + q; },
                                      [](double p, double, double) { return 1 + p; });
  const auto condition_at = [&](continuation::EventKind kind, double p) {
    const ExtendedSystem system{&orbits, kind, 1};
    return extend(system, position_of(system, {p, 0, 0}, VectorXd::Zero(1))).residual(1);
  };
  EXPECT_NEAR(condition_at(continuation::EventKind::fold, 0), 0, 1e-15);
  EXPECT_NEAR(condition_at(continuation::EventKind::fold, 0.3), 0.3, 1e-15);
  EXPECT_NEAR(condition_at(continuation::EventKind::period_doubling, -2), 0, 1e-15);
  EXPECT_NEAR(condition_at(continuation::EventKind::period_doubling, 0), 2, 1e-15);
}

/// An orbit whose guard is x - phase^2 for a turn that begins at this phase: it grazes at phase 0, where its
/// state is 0.
TEST(ExtendedSystem, OfAGraze) {
  orbits::PlaneOrbits orbits =
      test::plain_plane_of_one_number([](double p, double q, double x) { return 0.5 * x + p + q; },
                                      [](double, double, double) { return 0.5; });
  orbits.guard = [](const orbits::PlanePoint& at, const VectorXd& x,
                    const orbits::ArmedGuard&) -> std::optional<orbits::GuardMotion> {
    return orbits::GuardMotion{x(0) - at.phase_rad * at.phase_rad, -2 * at.phase_rad, -2};
  };
  const ExtendedSystem system{&orbits, continuation::EventKind::graze, 1};
  const Extended extended = extend(system, position_of(system, {0.1, 0.2, 0.3}, VectorXd::Constant(1, 0.6)));
  ASSERT_EQ(extended.evaluation, orbits::Evaluation::ok);
  ASSERT_EQ(extended.residual.size(), 3);
  EXPECT_NEAR(extended.residual(0), 0, 1e-15) << "the orbit closes";
  EXPECT_NEAR(extended.residual(1), 0.6 - 0.09, 1e-11);
  EXPECT_NEAR(extended.residual(2), -0.6, 1e-15);
  Eigen::MatrixXd jacobian(3, 4);
  jacobian << -0.5, 0, 2, 2, 1, -0.6, 0, 0, 0, -2, 0, 0;  // columns: state, phase, two parameters of width 2
  EXPECT_LT((extended.jacobian - jacobian).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_EQ(extended.critical.curvature, -2);
}

/// At a branch point the redundant equation is replaced by the second derivative, here zero by symmetry, and
/// the closing residual is kept.
TEST(ExtendedSystem, OfABranchPoint) {
  const orbits::PlaneOrbits orbits = test::plain_plane_of_one_number(
      [](double p, double q, double x) { return (1 + p) * x - x * x * x + q; },
      [](double p, double, double x) { return 1 + p - 3 * x * x; });
  const ExtendedSystem system{&orbits, continuation::EventKind::branch_point, 1};
  const Extended extended = extend(system, position_of(system, {0, 0.02, 0}, VectorXd::Zero(1)));
  ASSERT_EQ(extended.evaluation, orbits::Evaluation::ok);
  EXPECT_NEAR(std::abs(extended.critical.open_defect), 0.02, 1e-14);
  EXPECT_NEAR(extended.residual(0), 0, 1e-9);
  EXPECT_NEAR(extended.residual(1), 0, 1e-14);
  EXPECT_NEAR(std::abs(extended.jacobian(0, 0)), 6, 1e-4) << "the third derivative";
}

TEST(ExtendedSystem, WhereThereIsNoMachine) {
  orbits::PlaneOrbits orbits = curved_plane();
  const ExtendedSystem system{&orbits, continuation::EventKind::fold, 2};
  const continuation::Position at = position_of(system, {0.4, 0.2, 0}, Eigen::Vector2d(0.11, 0.23));
  for (const orbits::Evaluation evaluation : {orbits::Evaluation::infeasible, orbits::Evaluation::failed}) {
    orbits.returns = [evaluation](const orbits::PlanePoint&, VectorXd&, Eigen::MatrixXd*) {
      return evaluation;
    };
    EXPECT_EQ(extend(system, at).evaluation, evaluation);
  }
}

TEST(ExtendedSystem, KindsWithCurves) {
  using enum continuation::EventKind;
  for (const continuation::EventKind kind : {fold, period_doubling, neimark_sacker, branch_point, graze})
    EXPECT_TRUE(has_curve(kind)) << to_string(kind);
  for (const continuation::EventKind kind : {period_halving, sequence, stability})
    EXPECT_FALSE(has_curve(kind)) << to_string(kind);
}

}  // namespace
}  // namespace rubsweep::branch::curves
