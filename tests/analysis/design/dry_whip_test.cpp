#include "rubsweep/analysis/design/dry_whip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::design {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
const Complex i(0, 1);

model::Machine annular_machine(bool rigid) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{};
  if (rigid) machine.stops[0].casing.reset();
  return machine;
}

TEST(DryWhip, LeastFrictionOfAJeffcottRotorInARigidStopIsItsClosedForm) {
  model::Machine machine = annular_machine(true);
  for (const double zeta : {0.002, 0.02, 0.3}) {
    std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = zeta;
    const double b = 2e6 / (0.8 * std::pow(2 * pi * 30, 2));
    const auto found = least_dry_whip(scene::prepare_machine(machine), 0, 90);
    ASSERT_TRUE(found) << zeta;
    EXPECT_NEAR(found->least_friction, 2 * zeta * std::sqrt(1 + b) / b, 1e-9 * found->least_friction);
    EXPECT_NEAR(found->whirl_hz, 30 * std::sqrt(1 + b), 1e-9 * found->whirl_hz);
  }
}

/// Dynamic stiffness k - m w^2 - i c w of a mass in backward whirl e^{-i w t}.
Complex backward_stiffness(double mass_kg, double stiffness, double damping_ratio, double w) {
  return stiffness - mass_kg * w * w - 2.0 * i * damping_ratio * std::sqrt(stiffness * mass_kg) * w;
}

TEST(DryWhip, LeastFrictionOnAMovingCasingIsThatOfACloseScan) {
  const model::Machine machine = annular_machine(false);
  const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  const model::Casing& casing = *machine.stops[0].casing;
  double least = 1e9, whirl_hz = 0;
  for (double hz = 30; hz < 3000; hz += 1e-3) {
    const double w = 2 * pi * hz, k = rotor.mass_kg * std::pow(2 * pi * rotor.natural_frequency_hz, 2);
    const Complex compliance =
        1.0 / backward_stiffness(rotor.mass_kg, k, rotor.damping_ratio, w) +
        1.0 / backward_stiffness(casing.mass_kg, casing.stiffness_n_per_m, casing.damping_ratio, w);
    const double mu = -compliance.imag() / compliance.real();
    const double gain = -((1.0 + i * mu) * compliance).real();
    if (gain < 1 / machine.stops[0].stiffness_n_per_m || mu >= least) continue;
    least = mu;
    whirl_hz = hz;
  }
  const auto found = least_dry_whip(scene::prepare_machine(machine), 0, 90);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->least_friction, least, 1e-6 * least);
  EXPECT_LE(found->least_friction, least * (1 + 1e-12));
  EXPECT_NEAR(found->whirl_hz, whirl_hz, 2e-2);
}

/// Number of kicks, out of several, after which the balanced rotor keeps whirling backward in its stop.
int whips(model::Machine machine, double friction) {
  machine.stops[0].friction = model::ConstantFriction{friction};
  int count = 0;
  for (const double force_n : {50, 100, 200, 400, 800, 1600}) {
    machine.kick->force_n = force_n;
    sweep::Study study;
    study.machine = machine;
    study.grid = sweep::grid_of({60, scene::Eccentricity{0}});
    response::motion::Workspace workspace;
    count += response::motion::row_of(sweep::evaluate_cell(study, 0, workspace).motion_class).rubs;
  }
  return count;
}

/// Compares the formula with simulations.
TEST(DryWhip, GoesOnAboveTheLeastFrictionAlone) {
  const model::Machine machine = annular_machine(false);
  const auto found = least_dry_whip(scene::prepare_machine(machine), 0, 60);
  ASSERT_TRUE(found);
  EXPECT_EQ(whips(machine, 0.95 * found->least_friction), 0);
  EXPECT_GT(whips(machine, 1.2 * found->least_friction), 0);
}

TEST(DryWhip, KitThatIsAJeffcottRotorNeedsTheSame) {
  model::Machine kit = scene::light_shaft_machine();
  kit.stops[0].geometry = model::AnnularGeometry{};
  const scene::PreparedMachine prepared = scene::prepare_machine(kit);
  // The reduced kit is a single mass on a single spring.
  const structure::LinearSystem system = structure::system_at(prepared.assembly, 1);
  const double hz = std::sqrt(system.stiffness(0, 0) / system.mass(0, 0)) / (2 * pi);
  model::Machine jeffcott = annular_machine(false);
  jeffcott.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = hz, .damping_ratio = 0.02};
  const auto found = least_dry_whip(prepared, 0, 90),
             expected = least_dry_whip(scene::prepare_machine(jeffcott), 0, 90);
  ASSERT_TRUE(found && expected);
  EXPECT_NEAR(found->least_friction, expected->least_friction, 1e-4 * expected->least_friction);
}

TEST(DryWhip, NeverWhirlsFasterThanItRolls) {
  model::Machine machine = annular_machine(true);
  const double b = 2e6 / (0.8 * std::pow(2 * pi * 30, 2)), zeta = 0.02;
  // Rolling in the clearance of 1 mm at 90 Hz shaft speed is a whirl at 45 Hz, with mu = 2 zeta w / (w^2 -
  // 1).
  machine.stops[0].contact_radius_m = 0.5e-3;
  const auto found = least_dry_whip(scene::prepare_machine(machine), 0, 90);
  ASSERT_TRUE(found);
  EXPECT_GT(b, 1);
  EXPECT_NEAR(found->whirl_hz, 45, 1e-9);
  EXPECT_NEAR(found->least_friction, 2 * zeta * 1.5 / (1.5 * 1.5 - 1), 1e-9);
  machine.stops[0].contact_radius_m = 0;
  EXPECT_FALSE(least_dry_whip(scene::prepare_machine(machine), 0, 90));
}

TEST(DryWhip, NeedsAReceptanceBeyondResonanceAndAStiffWall) {
  EXPECT_FALSE(friction_of_dry_whip({1, 0.1}, 1e9)) << "below resonance";
  EXPECT_FALSE(friction_of_dry_whip({-1, 0.1}, 0.9)) << "too soft a wall";
  EXPECT_DOUBLE_EQ(friction_of_dry_whip({-1, 0.1}, 1.1).value(), 0.1);
}

TEST(DryWhip, LargestFrictionIsThatOfEveryForm) {
  EXPECT_EQ(largest_friction(model::NoFriction{}, 10), 0);
  EXPECT_EQ(largest_friction(model::ConstantFriction{0.2}, 10), 0.2);
  EXPECT_NEAR(largest_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0.01}}, 10), 0.2, 1e-12)
      << "with the viscous part";
}

}  // namespace
}  // namespace rubsweep::design
