#include "rubsweep/core/structure/support_mass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/structure/steel.hpp"
#include "core/structure/written_rotor.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/free_modes.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::structure {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// A disc between two bearings, and a seal at a place of the shaft that has no disc.
model::RotorKit rotor_with_seal() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.8, 0.03)};
  kit.discs = {
      {.position_m = 0.4, .mass_kg = 10, .polar_inertia_kg_m2 = 2e-2, .diametral_inertia_kg_m2 = 1.1e-2}};
  kit.supports = {isotropic_support(0, 5e6), isotropic_support(0.8, 3e6), isotropic_support(0.3, 1e5)};
  kit.supports[0].damping_x_ns_per_m = kit.supports[0].damping_y_ns_per_m = 200;
  kit.supports[2].damping_x_ns_per_m = kit.supports[2].damping_y_ns_per_m = 300;
  kit.supports[2].stiffness_xy_n_per_m = 2e4, kit.supports[2].stiffness_yx_n_per_m = -2e4;
  kit.damping_ratio = kit.rotating_damping_ratio = {0.0};
  kit.elements = 12;
  return kit;
}

/// Free vibrations up to a frequency, one of each conjugate pair, slowest first.
std::vector<Complex> slow(const Eigen::VectorXcd& rates, double up_to_hz) {
  std::vector<Complex> found;
  for (const Complex& rate : rates)
    if (rate.imag() > 1 && std::abs(rate) < 2 * pi * up_to_hz) found.push_back(rate);
  std::ranges::sort(found, {}, [](const Complex& rate) { return rate.imag(); });
  return found;
}

std::vector<Complex> slow_of_full(const model::RotorKit& kit, double speed_hz, double up_to_hz) {
  const FullSystem full = full_system(assemble_beam_shaft(kit, {}), kit);
  const double w = 2 * pi * speed_hz;
  return slow(free_modes(matrices_at(full, w, w), {0, 2 * pi * up_to_hz}).rate_per_s, up_to_hz);
}

void expect_written_rates(const model::RotorKit& kit, double within) {
  const WrittenRotor written(kit, assemble_beam_shaft(kit, {}));
  for (const double speed_hz : {0.0, 60.0, 150.0}) {
    const auto truth = slow(written.rates(2 * pi * speed_hz), 1000),
               found = slow_of_full(kit, speed_hz, 1000);
    ASSERT_GE(truth.size(), 4U);
    ASSERT_EQ(found.size(), truth.size()) << speed_hz;
    for (std::size_t k = 0; k < truth.size(); ++k)
      EXPECT_LT(std::abs(found[k] - truth[k]), within * std::abs(truth[k])) << k << " at " << speed_hz;
  }
}

/// The written matrices have a motion that grows at 1e5 1/s. The others are those of the rotor.
TEST(SupportMass, BelowZeroLeavesTheModesAndAddsNoneThatGrows) {
  model::RotorKit kit = rotor_with_seal();
  kit.elements = 24;
  kit.supports[2].stiffness_xy_n_per_m = kit.supports[2].stiffness_yx_n_per_m = 0;
  kit.supports[2].mass_x_kg = kit.supports[2].mass_y_kg = -0.4;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  EXPECT_EQ(shaft.added_mass[0], shaft.added_mass[1]);
  EXPECT_GT(WrittenRotor(kit, shaft).rates(300).real().maxCoeff(), 1e4);
  expect_written_rates(kit, 1e-4);
  const FullSystem full = full_system(shaft, kit);
  const SpeedMatrices now = matrices_at(full, 300, 300);
  EXPECT_LT(all_rates_per_s(now, 1e4).real().maxCoeff(), 0);
  EXPECT_TRUE(dissipates(now.mass, now.damping, now.stiffness, 1e-12));
}

/// Problem of a seal of this mass at the end of the shaft; empty: none.
std::string problem_of(double mass_kg, std::optional<int> modes) {
  model::RotorKit kit = rotor_with_seal();
  kit.elements = 24;
  kit.modes = modes;
  kit.supports[2].position_m = 0.78;
  kit.supports[2].mass_x_kg = mass_kg;
  try {
    assemble_beam_shaft(kit, {});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SupportMass, ThatASlowModeLacksIsRefused) {
  EXPECT_EQ(problem_of(-0.4, 6), "");
  EXPECT_NE(problem_of(-30, 6).find("rotor.supports.2: its fluid takes all mass of a mode of "),
            std::string::npos);
  // A range of modes that is asked for is to be right.
  EXPECT_NE(problem_of(-0.4, {}).find("modes up to 2000 Hz are needed"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::structure
