#include "rubsweep/core/structure/full_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/structure/steel.hpp"
#include "core/structure/whirl_eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/structure/free_modes.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

/// Overhung disc, unequal dampers, a seal that drives, tabled bearing or not.
model::RotorKit seal_kit() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.3, 0.02), steel_segment(0.2, 0.015)};
  kit.discs = {
      {.position_m = 0.4, .mass_kg = 2, .polar_inertia_kg_m2 = 4e-3, .diametral_inertia_kg_m2 = 2e-3}};
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  kit.supports[0].damping_x_ns_per_m = 700;
  kit.supports[1].damping_y_ns_per_m = 40;
  kit.supports[1].stiffness_xy_n_per_m = 2e5;
  kit.supports[1].stiffness_yx_n_per_m = -2e5;
  kit.elements = 10;
  return kit;
}

TEST(FullSystem, RatesAreTheWhirlEigenvalues) {
  const model::RotorKit kit = seal_kit();
  const FullSystem full_matrices = full_system(assemble_beam_shaft(kit, {}), kit);
  for (const double speed : {0.0, 2 * pi * 300}) {
    const double radius = 2 * pi * 3000;
    const Eigen::VectorXcd found = free_modes(matrices_at(full_matrices, speed), {0, radius}).rate_per_s;
    int within = 0;
    for (const auto& rate : whirl_eigenvalues(full(kit), speed)) {
      if (std::abs(rate) > radius) continue;
      ++within;
      EXPECT_LT((found.array() - rate).abs().minCoeff(), 1e-7 * std::abs(rate)) << rate;
    }
    EXPECT_GE(within, 6);
    EXPECT_GE(found.size(), 2 * within);
    EXPECT_GT(found.real().maxCoeff(), 1);  // the seal makes a whirl grow
  }
}

TEST(FullSystem, EveryModeHasItsStructuralDamping) {
  model::RotorKit kit = seal_kit();
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  kit.damping_ratio = {0.05, 0.02, 0.3};
  const FullSystem full_matrices = full_system(assemble_beam_shaft(kit, {}), kit);
  const PlaneModes modes = plane_modes(assemble_beam_shaft(kit, {}).plane_mass(0),
                                       assemble_beam_shaft(kit, {}).plane_stiffness(0), 5);
  const Eigen::VectorXcd found =
      free_modes(matrices_at(full_matrices, 0), {0, 1.01 * modes.rad_per_s(4)}).rate_per_s;
  const double ratios[] = {0.05, 0.02, 0.3, 0.3, 0.3};
  for (Eigen::Index j = 0; j < 5; ++j) {
    const double z = ratios[j];
    const std::complex<double> rate = modes.rad_per_s(j) * std::complex<double>(-z, std::sqrt(1 - z * z));
    EXPECT_LT((found.array() - rate).abs().minCoeff(), 1e-8 * std::abs(rate)) << j;
  }
}

TEST(FullSystem, DampingThatTurnsMakesTheFirstWhirlGrowAboveItsSpeed) {
  model::RotorKit kit = seal_kit();
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  for (auto& disc : kit.discs) disc.polar_inertia_kg_m2 = 0;
  for (auto& segment : kit.shaft) segment.density_kg_per_m3 = 1e-3;  // no gyroscopic moment
  kit.rotating_damping_ratio = {0.01};
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const FullSystem full_matrices = full_system(shaft, kit);
  const double first = plane_modes(shaft.plane_mass(0), shaft.plane_stiffness(0), 1).rad_per_s(0);
  for (const double speed : {0.99 * first, 1.01 * first}) {
    const double growth =
        free_modes(matrices_at(full_matrices, speed), {0, 1.5 * first}).rate_per_s.real().maxCoeff();
    EXPECT_EQ(growth > 0, speed > first) << speed / first;
  }
}

TEST(FullSystem, TablesAddWhatTheMiddleSpeedLacks) {
  model::RotorKit kit = seal_kit();
  model::SupportTable table;
  table.speed_hz = {0, 100, 200};
  for (auto& column : table.columns) column = {0, 0, 0};
  table.columns[0] = {1e6, 2e6, 4e6};
  table.columns[3] = {1e6, 2e6, 3e6};
  model::Support support = isotropic_support(0.5, 1);
  kit.supports[1] = model::with_table(support, table);
  const FullSystem tabled = full_system(assemble_beam_shaft(kit, {}), kit);
  const SpeedMatrices found = matrices_at(tabled, 2 * pi * 200, 2 * pi * 200);
  kit.supports[1] = isotropic_support(0.5, 4e6);
  kit.supports[1].stiffness_y_n_per_m = 3e6;
  const SpeedMatrices typed = matrices_at(full_system(assemble_beam_shaft(kit, {}), kit), 2 * pi * 200);
  EXPECT_LT((found.stiffness - typed.stiffness).norm(), 1e-12 * typed.stiffness.norm());
  EXPECT_EQ(found.damping, typed.damping);
}

}  // namespace
}  // namespace rubsweep::structure
