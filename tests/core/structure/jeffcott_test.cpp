#include "rubsweep/core/structure/jeffcott.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

namespace rubsweep::structure {
namespace {

using Casings = std::vector<std::optional<model::Casing>>;

const model::JeffcottRotor rotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
const model::Casing first{.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1};
const model::Casing second{.mass_kg = 0.03, .stiffness_n_per_m = 1.18e6, .damping_ratio = 0};

/// Every entry of `matrix` is zero but the diagonal, which is `diagonal`.
void expect_diagonal(const Eigen::MatrixXd& matrix, const std::vector<double>& diagonal) {
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  ASSERT_EQ(matrix.rows(), n);
  ASSERT_EQ(matrix.cols(), n);
  for (Eigen::Index row = 0; row < n; ++row) {
    for (Eigen::Index column = 0; column < n; ++column) {
      if (row == column) {
        EXPECT_DOUBLE_EQ(matrix(row, column), diagonal[static_cast<std::size_t>(row)]);
      } else {
        EXPECT_EQ(matrix(row, column), 0) << row << ", " << column;
      }
    }
  }
}

/// The point moves with coordinates `x` and `x + 1` and with nothing else.
void expect_point_at(const Point& point, Eigen::Index x, Eigen::Index n) {
  ASSERT_EQ(point.map.cols(), n);
  for (Eigen::Index column = 0; column < n; ++column) {
    EXPECT_EQ(point.map(0, column), column == x ? 1 : 0);
    EXPECT_EQ(point.map(1, column), column == x + 1 ? 1 : 0);
  }
}

TEST(JeffcottAssemble, EveryEntryOfTheMatrices) {
  const LinearSystem system = assemble_jeffcott(rotor, {first, std::nullopt, second}).system;
  EXPECT_EQ(system.coordinates(), 6);
  expect_diagonal(system.mass, {0.8, 0.8, 0.05, 0.05, 0.03, 0.03});
  // m (2 pi f)^2 and 2 zeta m 2 pi f of the rotor, 2 zeta sqrt(k m) of the casings; digits by hand.
  expect_diagonal(system.stiffness, {28424.460675137347, 28424.460675137347, 5e5, 5e5, 1.18e6, 1.18e6});
  expect_diagonal(system.damping,
                  {6.031857894892402, 6.031857894892402, 31.622776601683796, 31.622776601683796, 0, 0});
}

TEST(JeffcottAssemble, PointsFollowTheStopsAndRigidCasingsHaveNone) {
  const Assembly assembly = assemble_jeffcott(rotor, {first, std::nullopt, second});
  const LinearSystem& system = assembly.system;
  const auto& casing_points = assembly.casing_points;
  ASSERT_EQ(casing_points.size(), 3u);
  EXPECT_FALSE(casing_points[1]);
  ASSERT_EQ(system.points.size(), 3u);
  EXPECT_EQ(assembly.rotor_points, std::vector<int>(3, 0));
  EXPECT_EQ(assembly.contact_mass_kg, std::vector<double>(3, 0.8));
  expect_point_at(system.points[0], 0, 6);
  expect_point_at(system.points[static_cast<std::size_t>(casing_points[0].value())], 2, 6);
  expect_point_at(system.points[static_cast<std::size_t>(casing_points[2].value())], 4, 6);
}

TEST(JeffcottAssemble, RigidCasingsHaveNoState) {
  for (const Casings& casings : {Casings{}, Casings{std::nullopt}, Casings{std::nullopt, std::nullopt}}) {
    const Assembly assembly = assemble_jeffcott(rotor, casings);
    EXPECT_EQ(assembly.system.coordinates(), 2);
    EXPECT_EQ(assembly.system.points.size(), 1u);
    EXPECT_EQ(assembly.casing_points, std::vector<std::optional<int>>(casings.size()));
  }
}

TEST(JeffcottAssemble, FreeRotorDecaysAtItsFrequencyAndDampingRatio) {
  // Root of m s^2 + c s + k: -zeta w0 +- i w0 sqrt(1 - zeta^2).
  const LinearSystem system = assemble_jeffcott(rotor, {}).system;
  const double m = system.mass(0, 0), c = system.damping(0, 0), k = system.stiffness(0, 0);
  const std::complex<double> root = (-c + std::sqrt(std::complex<double>(c * c - 4 * m * k))) / (2 * m);
  EXPECT_NEAR(std::abs(root) / (2 * std::numbers::pi), 30, 1e-12);
  EXPECT_NEAR(-root.real() / std::abs(root), 0.02, 1e-15);
}

TEST(JeffcottAssemble, UnbalanceTurnsFromXTowardsYWithForceMassTimesEccentricityTimesSpeedSquared) {
  const LinearSystem system = assemble_jeffcott(rotor, {first}).system;
  const double e = 3e-4, w = 471;
  for (const double phase : {0.0, 0.3, 1.9, 4.4}) {
    const Eigen::VectorXd force = e * w * w * (system.unbalance_kg * std::polar(1.0, phase)).real();
    const double centrifugal = rotor.mass_kg * e * w * w;
    EXPECT_NEAR(force(0), centrifugal * std::cos(phase), 1e-12 * centrifugal);
    EXPECT_NEAR(force(1), centrifugal * std::sin(phase), 1e-12 * centrifugal);
    EXPECT_EQ(force.tail(2), Eigen::Vector2d::Zero());
  }
}

TEST(JeffcottAssemble, WeightActsOnRotorAndMovingCasingsAlongMinusY) {
  const LinearSystem system = assemble_jeffcott(rotor, {first, std::nullopt, second}).system;
  Eigen::VectorXd weight(6);
  weight << 0, -0.8, 0, -0.05, 0, -0.03;
  EXPECT_EQ(system.weight_kg, weight);
}

}  // namespace
}  // namespace rubsweep::structure
