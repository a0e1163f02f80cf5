#include "rubsweep/identify/whirl_modes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "rubsweep/structure/beam_shaft.hpp"
#include "scene/kit_machine.hpp"
#include "scene/table_machine.hpp"
#include "structure/steel.hpp"

namespace rubsweep::identify {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Bearings that couple the planes and damp, on pedestals.
model::Machine coupled_machine() {
  model::RotorKit kit;
  kit.shaft = {structure::steel_segment(1.5, 0.05)};
  kit.discs = {
      {.position_m = 0.5, .mass_kg = 32, .polar_inertia_kg_m2 = 0.32, .diametral_inertia_kg_m2 = 0.18}};
  kit.supports = {structure::isotropic_support(0, 1e6), structure::isotropic_support(1.5, 2e6)};
  for (auto& support : kit.supports) {
    support.stiffness_xy_n_per_m = 2e5;
    support.stiffness_yx_n_per_m = -1e5;
    support.damping_x_ns_per_m = 300;
    support.pedestal = {.mass_kg = 5, .stiffness_x_n_per_m = 4e6, .stiffness_y_n_per_m = 8e6};
  }
  kit.damping_ratio = {0.01};
  model::Machine machine = scene::one_side_machine();
  machine.rotor = kit;
  machine.stops.front().position_m = 0.7;
  return machine;
}

TEST(WhirlModes, OfSupportsByATableAreThoseOfTheNumbersTypedIn) {
  model::Machine machine = scene::table_machine();
  // So few elements that all modes are kept: nothing but the table tells the two apart.
  model::kit_of(machine)->elements = 6;
  // Without the damping that is said by modes, which are others at every speed.
  model::kit_of(machine)->damping_ratio = {0};
  const WhirlProblem problem(free_rotor(machine));
  for (std::size_t row = 0; row < scene::table_speeds_hz.size(); ++row) {
    model::Machine typed = scene::typed_machine(row);
    model::kit_of(typed)->elements = 6;
    model::kit_of(typed)->damping_ratio = {0};
    const double speed_hz = scene::table_speeds_hz[row];
    const auto found = problem.at(speed_hz), expected = WhirlProblem(free_rotor(typed)).at(speed_hz);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_LT(std::abs(found[k].root_per_s - expected[k].root_per_s),
                1e-8 * std::abs(expected[k].root_per_s))
          << row << " " << k;
      EXPECT_NEAR(found[k].forward_share, expected[k].forward_share, 1e-8);
    }
  }
}

TEST(WhirlModes, SolveTheEquationsOfMotion) {
  const FreeRotor rotor = free_rotor(coupled_machine());
  const double speed_hz = 70;
  const auto modes = WhirlProblem(rotor).at(speed_hz);
  ASSERT_GE(modes.size(), 8u);
  const Eigen::MatrixXd damping = rotor.system.damping + 2 * pi * speed_hz * rotor.system.gyroscopic;
  for (std::size_t k = 0; k < 8; ++k) {
    const Complex root = modes[k].root_per_s;
    const Eigen::VectorXcd q = modes[k].shape;
    const Eigen::VectorXcd elastic = rotor.system.stiffness.cast<Complex>() * q;
    const Eigen::VectorXcd rest = root * root * (rotor.system.mass.cast<Complex>() * q) +
                                  root * (damping.cast<Complex>() * q) + elastic;
    EXPECT_LT(rest.norm(), 1e-9 * elastic.norm()) << k;
    EXPECT_GE(root.imag(), modes[k > 0 ? k - 1 : 0].root_per_s.imag());
  }
}

TEST(WhirlModes, AreThoseOfTheFullModel) {
  // Undamped, so that the full model needs no modes of its own to be damped by.
  model::Machine machine = coupled_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.damping_ratio = {0};
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, {0.7});
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  FreeRotor full = free_rotor(machine);
  full.system = structure::project(shaft, {identity, identity});
  full.spin = Eigen::MatrixXd::Zero(full.system.coordinates(), full.system.coordinates());
  const auto expected = WhirlProblem(full).at(70), found = WhirlProblem(free_rotor(machine)).at(70);
  for (std::size_t k = 0; k < 8; ++k)
    EXPECT_NEAR(std::abs(found[k].root_per_s - expected[k].root_per_s), 0,
                2e-4 * std::abs(expected[k].root_per_s))
        << k;
}

TEST(WhirlModes, DirectionIsThatOfTheOrbits) {
  const FreeRotor rotor = free_rotor(coupled_machine());
  for (const WhirlMode& mode : WhirlProblem(rotor).at(70)) {
    if (mode.frequency_hz() > 300) break;
    // z = x + iy turns forward by (x + iy) / 2 and backward by (x* + iy*) / 2.
    const Eigen::VectorXcd x = rotor.x * mode.shape, y = rotor.y * mode.shape;
    const double forward = (x + Complex(0, 1) * y).squaredNorm(),
                 backward = (x - Complex(0, 1) * y).squaredNorm();
    if (std::abs(mode.forward_share - 0.5) > 0.1) {
      EXPECT_EQ(forward > backward, mode.forward_share > 0.5) << mode.frequency_hz();
    }
    EXPECT_GE(mode.forward_share, -1e-12);
    EXPECT_LE(mode.forward_share, 1 + 1e-12);
  }
}

}  // namespace
}  // namespace rubsweep::identify
