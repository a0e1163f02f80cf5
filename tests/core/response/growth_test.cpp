#include "rubsweep/core/response/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/response/companion_growth.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response {
namespace {

std::vector<double> contributions(const Growth& turn, std::vector<double>& section, int turns) {
  std::vector<double> all;
  for (int k = 0; k < turns; ++k) all.push_back(turn(section).value());
  return all;
}

/// Section after so many turns, kick left out.
std::vector<double> late_section(proof::SceneMap& map, int turns) {
  std::vector<double> section{0.5, -0.2, 0, 0, 0.1, -1.2, 0, 0};
  for (int k = 0; k < turns; ++k) EXPECT_TRUE(map(section));
  return section;
}

TEST(Growth, TangentOfAStableOrbitDecaysByItsMultiplier) {
  // The tangential motion under a wall at 90 degrees decays by zeta omega0 T per turn.
  const test::OneSideRotor rotor;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of(rotor).scene, {}, modes);
  auto section = late_section(map, 500);
  const auto exponent = exponent_of(contributions(tangent_growth(map), section, 400));
  EXPECT_NEAR(exponent.per_revolution,
              -2 * std::numbers::pi * rotor.damping_ratio * rotor.natural_frequency_hz / rotor.speed_hz,
              1e-6);
}

TEST(Growth, TangentAndCompanionTellTheSameExponent) {
  test::OneSideRotor rotor;  // an irregular cell at the rim of a tongue
  rotor.speed_hz = 69;
  rotor.whirl_ratio = 0.97;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of(rotor).scene, {}, modes);
  const auto start = late_section(map, 100);
  auto a = start, b = start;
  const auto tangent = exponent_of(contributions(tangent_growth(map), a, 600));
  const auto companion = exponent_of(contributions(test::companion_growth(std::ref(map), b), b, 600));
  EXPECT_EQ(a, b);
  EXPECT_NEAR(tangent.per_revolution, companion.per_revolution, 1e-3 + 0.2 * tangent.error_bar);
}

/// Where the turns have no closed form the tangent takes differences.
TEST(Growth, OfTurnsByTheAdaptiveSolver) {
  integrate::run::SolverOptions adaptive;
  adaptive.method = integrate::run::Method::adaptive;
  adaptive.relative_tolerance = 1e-10;
  integrate::exact::modes::ModeCache modes;
  const auto scene = test::cell_of({}).scene;
  proof::SceneMap exact(scene, {}, modes), by_steps(scene, adaptive, modes);
  const auto start = late_section(exact, 20);
  auto a = start, b = start;
  const auto from_exact = contributions(tangent_growth(exact), a, 10);
  const auto from_steps = contributions(tangent_growth(by_steps), b, 10);
  for (std::size_t k = 0; k < from_exact.size(); ++k) EXPECT_NEAR(from_exact[k], from_steps[k], 2e-3) << k;
}

TEST(Growth, EndsWhereTheTurnFails) {
  integrate::run::SolverOptions solver;
  solver.max_steps_per_revolution = 1;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(test::cell_of({}).scene, solver, modes);
  std::vector<double> section(8);
  EXPECT_FALSE(tangent_growth(map)(section));
  EXPECT_FALSE(test::companion_growth(std::ref(map), section)(section));
}

TEST(GrowthFirstDisturbance, HasTheSeparationAndAShareOfEveryCoordinate) {
  for (std::size_t states = 1; states <= 24; ++states) {
    const Eigen::VectorXd away = first_disturbance(states);
    EXPECT_GT(away.cwiseAbs().minCoeff(), 0.1 * separation / std::sqrt(static_cast<double>(states)));
    EXPECT_NEAR(away.norm(), separation, 1e-15);
  }
}

TEST(GrowthCompanion, IsPulledBackAlongTheLineToTheBase) {
  const std::vector<double> base{1, 2};
  test::Companion companion(base);
  companion.state()[0] = 1 + 3e-3;
  companion.state()[1] = 2 - 4e-3;
  EXPECT_NEAR(companion.pull_back(base), std::log(5e-3 / separation), 1e-9);
  EXPECT_NEAR(companion.state()[0], 1 + 0.6 * separation, 1e-15);
  EXPECT_NEAR(companion.state()[1], 2 - 0.8 * separation, 1e-15);
}

TEST(GrowthCompanion, StartsAnewWhenItFallsOntoTheBase) {
  const std::vector<double> base{1, 2};
  test::Companion companion(base);
  companion.state()[0] = 1;
  companion.state()[1] = 2;
  EXPECT_NEAR(companion.pull_back(base), std::log(1e-10), 1e-9);
  EXPECT_NEAR(std::hypot(companion.state()[0] - 1, companion.state()[1] - 2), separation, 1e-12);
}

}  // namespace
}  // namespace rubsweep::response
