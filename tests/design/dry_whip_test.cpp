#include "rubsweep/design/dry_whip.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/structure/system_at.hpp"
#include "scene/kit_machine.hpp"

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

/// Growth per second of the rotor that is pressed on its casing all along, z'' and the casing's with the
/// stop's spring times 1 + i mu: beyond the least friction the backward whirl feeds itself.
double growth_in_contact(const model::Machine& machine, double friction) {
  const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  const model::Casing& casing = *machine.stops[0].casing;
  const Eigen::Vector2d mass(rotor.mass_kg, casing.mass_kg);
  const double k = rotor.mass_kg * std::pow(2 * pi * rotor.natural_frequency_hz, 2);
  const Eigen::Vector2d stiffness(k, casing.stiffness_n_per_m);
  const Eigen::Vector2d damping(
      2 * rotor.damping_ratio * std::sqrt(k * rotor.mass_kg),
      2 * casing.damping_ratio * std::sqrt(casing.stiffness_n_per_m * casing.mass_kg));
  Eigen::Matrix4cd rates = Eigen::Matrix4cd::Zero();
  rates.topRightCorner<2, 2>().setIdentity();
  const Complex spring = machine.stops[0].stiffness_n_per_m * (1.0 + i * friction);
  for (int row = 0; row < 2; ++row) {
    rates(2 + row, row) = -(stiffness(row) + spring) / mass(row);
    rates(2 + row, 1 - row) = spring / mass(row);
    rates(2 + row, 2 + row) = -damping(row) / mass(row);
  }
  return Eigen::ComplexEigenSolver<Eigen::Matrix4cd>(rates, false).eigenvalues().real().maxCoeff();
}

TEST(DryWhip, GrowsBeyondTheLeastFrictionAgainstAMovingCasing) {
  const model::Machine machine = annular_machine(false);
  const auto found = least_dry_whip(scene::prepare_machine(machine), 0, 90);
  ASSERT_TRUE(found);
  EXPECT_LT(growth_in_contact(machine, 0.999 * found->least_friction), 0);
  EXPECT_GT(growth_in_contact(machine, 1.001 * found->least_friction), 0);
}

TEST(DryWhip, KitThatIsAJeffcottRotorNeedsTheSame) {
  model::Machine kit = scene::light_shaft_machine();
  kit.stops[0].geometry = model::AnnularGeometry{};
  const scene::PreparedMachine prepared = scene::prepare_machine(kit);
  // The kit as the one mass on the one spring that its reduction is.
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
  // Rolling in the clearance of 1 mm at 90 Hz whirls at 45 Hz, where mu = 2 zeta w / (w^2 - 1).
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

TEST(LargestFriction, IsThatOfEveryForm) {
  EXPECT_EQ(largest_friction(model::NoFriction{}, 10), 0);
  EXPECT_EQ(largest_friction(model::ConstantFriction{0.2}, 10), 0.2);
  EXPECT_NEAR(largest_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0.01}}, 10), 0.2, 1e-12)
      << "with the viscous part";
}

}  // namespace
}  // namespace rubsweep::design
