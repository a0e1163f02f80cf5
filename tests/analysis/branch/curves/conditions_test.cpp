#include "rubsweep/analysis/branch/curves/conditions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace rubsweep::branch::curves {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Jet of a monodromy matrix that depends on the state and one parameter, at state 0.
template <class Monodromy>
MonodromyJet jet_of(const Monodromy& monodromy, Eigen::Index states, double parameter) {
  constexpr double step = 1e-4;
  const VectorXd origin = VectorXd::Zero(states);
  return {monodromy(origin, parameter),
          {(monodromy(origin, parameter + step) - monodromy(origin, parameter - step)) / (2 * step)},
          [=](const VectorXd& direction) -> std::optional<MonodromyPair> {
            return MonodromyPair{monodromy(step * direction, parameter),
                                 monodromy(-step * direction, parameter), step};
          }};
}

MonodromyJet without_neighbours(MonodromyJet jet) {
  jet.along = [](const VectorXd&) { return std::nullopt; };
  return jet;
}

/// x -> x + p x + a x^2 + b x^3, y -> y / 2 + x y: only x is critical.
TEST(ConditionsSingularCondition, OfAFold) {
  constexpr double a = 0.7, b = -0.4, p = 0.01;
  const auto monodromy = [](const VectorXd& x, double at) {
    return MatrixXd(
        (Eigen::Matrix2d() << 1 + at + 2 * a * x(0) + 3 * b * x(0) * x(0), 0, x(1), 0.5 + x(0)).finished());
  };
  const MonodromyJet jet = jet_of(monodromy, 2, p);
  const auto condition = singular_condition(jet, 1);
  ASSERT_TRUE(condition);
  const Critical& critical = condition->critical;
  EXPECT_NEAR(condition->value, p, 1e-14);
  EXPECT_NEAR(std::abs(critical.left(0)), 1, 1e-12);
  EXPECT_NEAR(std::abs(critical.right(0)), 1, 1e-12);
  const double signs = critical.left(0) * critical.right(0);
  EXPECT_NEAR(signs, 1, 1e-12) << "M - 1 is positive along x";
  EXPECT_NEAR(condition->by_state(0), 2 * a, 1e-10);
  EXPECT_NEAR(condition->by_state(1), 0, 1e-10);
  EXPECT_NEAR(condition->by_parameter(0), 1, 1e-10);
  EXPECT_NEAR(critical.quadratic * critical.left(0), 2 * a, 1e-10);
  EXPECT_NEAR(critical.cubic, 6 * b, 1e-6);
  EXPECT_FALSE(singular_condition(without_neighbours(jet), 1));
}

/// x -> -(1 + p) x + a x^2 + b x^3: the coefficient of the normal form is a^2 + b; `cubic` is six times as
/// large.
TEST(ConditionsSingularCondition, OfAPeriodDoubling) {
  constexpr double a = 0.7, b = -0.4;
  const auto monodromy = [](const VectorXd& x, double at) {
    return MatrixXd(MatrixXd::Constant(1, 1, -(1 + at) + 2 * a * x(0) + 3 * b * x(0) * x(0)));
  };
  const auto condition = singular_condition(jet_of(monodromy, 1, 0), -1);
  ASSERT_TRUE(condition);
  EXPECT_NEAR(condition->value, 0, 1e-14);
  const double signs = condition->critical.left(0) * condition->critical.right(0);
  EXPECT_NEAR(condition->critical.cubic * signs, 6 * (a * a + b), 1e-6);
  EXPECT_NEAR(condition->by_parameter(0) * signs, -1, 1e-10);
}

/// A rotation by 1 rad with modulus 1 + p + x, and another multiplier 0.3, in skew coordinates: the product
/// of the pair is (1 + p + x)^2.
TEST(ConditionsPairCondition, OfATorus) {
  constexpr double p = 0.02;
  Eigen::Matrix3d skew;
  skew << 1, 0.4, -0.2, 0, 1, 0.3, 0.5, 0, 1;
  const auto monodromy = [&](const VectorXd& x, double at) {
    Eigen::Matrix3d plain = Eigen::Matrix3d::Zero();
    plain.topLeftCorner<2, 2>() = (1 + at + x(0)) * Eigen::Rotation2Dd(1).toRotationMatrix();
    plain(2, 2) = 0.3;
    return MatrixXd(skew * plain * skew.inverse());
  };
  const MonodromyJet jet = jet_of(monodromy, 3, p);
  const auto condition = pair_condition(jet);
  ASSERT_TRUE(condition);
  EXPECT_NEAR(condition->value, (1 + p) * (1 + p) - 1, 1e-12);
  EXPECT_NEAR(condition->critical.pair_sum, 2 * (1 + p) * std::cos(1), 1e-12);
  EXPECT_NEAR(condition->by_parameter(0), 2 * (1 + p), 1e-8);
  EXPECT_FALSE(pair_condition(without_neighbours(jet)));
}

/// M = (1 + p) R + x e e^T, where R rotates by 90 degrees and e is the first axis. The trace is x; the
/// determinant does not depend on x to first order. Along (x, y) the slope must equal the closed form, for
/// any basis of the pair's plane.
TEST(ConditionsPairCondition, SlopeAlongTheState) {
  const auto monodromy = [](const VectorXd& x, double at) {
    MatrixXd m(2, 2);
    m << x(0), -(1 + at) + x(1), 1 + at, x(1);
    return m;  // the determinant is x y + (1 + p) (1 + p - y)
  };
  const auto condition = pair_condition(jet_of(monodromy, 2, 0.1));
  ASSERT_TRUE(condition);
  EXPECT_NEAR(condition->value, 0.21, 1e-12);
  EXPECT_NEAR(condition->by_parameter(0), 2.2, 1e-8);
}

TEST(ConditionsPairCondition, OneMultiplierIsNoPair) {
  const auto monodromy = [](const VectorXd&, double) { return MatrixXd(MatrixXd::Constant(1, 1, 1)); };
  EXPECT_FALSE(pair_condition(jet_of(monodromy, 1, 0)));
}

}  // namespace
}  // namespace rubsweep::branch::curves
