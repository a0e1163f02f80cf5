#include "rubsweep/analysis/design/unbalance_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/analysis/design/static_line.hpp"

namespace rubsweep::design {
namespace {

/// A disc in the middle of a massless shaft on two springs moves like a disc on one spring.
TEST(UnbalanceCases, ResponseAndBearingForcesOfAMidspanDisc) {
  const WholeRotor rotor(scene::light_shaft_machine());
  const std::vector<UnbalanceCase> cases = rotor.cases(1e-5, 100);
  ASSERT_GE(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "configured");
  EXPECT_EQ(cases[1].name, "mode 1");
  ASSERT_EQ(rotor.bearings().size(), 2u);
  for (const Bearing& bearing : rotor.bearings()) EXPECT_NEAR(bearing.static_load_n, 0.4 * 9.80665, 1e-5);
  EXPECT_EQ(rotor.midspan(), rotor.place(0.2));
  const double unbalance_kg_m = 4 * 6350e-6 * 0.8 / 6000, speed_hz = 45;
  const Eigen::VectorXcd q = rotor.response(cases[1].unbalance_kg_m, speed_hz);
  const auto disc = rotor.rotor().x.row(rotor.place(0.2));
  const double moved_m = std::abs((disc * q).value());
  // The forces of the springs give the stiffness of shaft and springs in series; the response must have this
  // stiffness.
  const double force_n = rotor.bearing_force_n(rotor.bearings()[0], q, speed_hz);
  EXPECT_NEAR(rotor.bearing_force_n(rotor.bearings()[1], q, speed_hz), force_n, 1e-6 * force_n);
  const double stiffness = 2 * force_n / moved_m, w = 2 * std::numbers::pi * speed_hz, mass_kg = 0.8;
  EXPECT_GT(stiffness, 3e4);
  EXPECT_LT(stiffness, 6e4) << "that of the springs alone";
  const std::complex<double> dynamic(stiffness - mass_kg * w * w,
                                     2 * 0.02 * std::sqrt(stiffness * mass_kg) * w);
  EXPECT_NEAR(moved_m, w * w * unbalance_kg_m / std::abs(dynamic), 1e-5 * moved_m);
}

TEST(UnbalanceCases, OfTheSecondModeAreInOppositePhaseByTheLoadsOfTheBearings) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.discs = {
      {.position_m = 0.1, .mass_kg = 0.8, .polar_inertia_kg_m2 = 4e-4, .diametral_inertia_kg_m2 = 2e-4},
      {.position_m = 0.3, .mass_kg = 0.4, .polar_inertia_kg_m2 = 4e-4, .diametral_inertia_kg_m2 = 2e-4}};
  const WholeRotor rotor(machine);
  // The rotor has 0.8 kg at a quarter of the span and 0.4 kg at three quarters.
  EXPECT_NEAR(rotor.bearings()[0].static_load_n, 0.7 * 9.80665, 1e-5);
  EXPECT_NEAR(rotor.bearings()[1].static_load_n, 0.5 * 9.80665, 1e-5);
  const std::vector<UnbalanceCase> cases = rotor.cases(1e-5, 100);
  ASSERT_EQ(cases.size(), 3u) << "nothing overhangs";
  const Eigen::VectorXcd planes = rotor.rotor().x * cases[2].unbalance_kg_m;
  double most = 0, least = 0;
  for (const auto& one : planes) most = std::max(most, one.real()), least = std::min(least, one.real());
  const double larger = 4 * 6350e-6 * 0.7 / 6000, smaller = 4 * 6350e-6 * 0.5 / 6000;
  EXPECT_NEAR(most - least, larger + smaller, 1e-9 * larger);
  EXPECT_NEAR(std::max(most, -least), larger, 1e-9 * larger);
}

TEST(UnbalanceCases, AnOverhangHasItsOwnAndSealsAreNoBearings) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.discs.push_back(
      {.position_m = 0.4, .mass_kg = 0.1, .polar_inertia_kg_m2 = 1e-5, .diametral_inertia_kg_m2 = 1e-5});
  kit.supports[1].position_m = 0.3;
  model::Support seal = kit.supports[1];
  seal.position_m = 0.2;
  seal.name = "SealElement_Seal 1";
  kit.supports.push_back(seal);
  seal.name.clear();
  seal.stiffness_x_n_per_m = seal.stiffness_y_n_per_m = 299;
  kit.supports.push_back(seal);
  EXPECT_TRUE(is_seal(kit, 2) && is_seal(kit, 3));
  EXPECT_FALSE(is_seal(kit, 0) || is_seal(kit, 1));
  const WholeRotor rotor(machine);
  ASSERT_EQ(rotor.bearings().size(), 2u);
  EXPECT_NEAR(rotor.bearings()[0].static_load_n + rotor.bearings()[1].static_load_n, 0.9 * 9.80665, 1e-5);
  EXPECT_NEAR(rotor.bearings()[1].static_load_n, (0.8 * 2 + 0.1 * 4) / 3 * 9.80665, 1e-4);
  const std::vector<UnbalanceCase> cases = rotor.cases(1e-5, 100);
  ASSERT_EQ(cases.back().name, "right end");
  const Eigen::VectorXcd planes = rotor.rotor().x * cases.back().unbalance_kg_m;
  EXPECT_NEAR(planes(planes.size() - 1).real(), 4 * 6350e-6 * 0.1 / 6000, 1e-12);
}

}  // namespace
}  // namespace rubsweep::design
