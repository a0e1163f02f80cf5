#include "rubsweep/analysis/linear/whirl_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/linear/exported_matrices.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/one_side_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "core/structure/steel.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A machine with damped bearings that couple both planes, on pedestals.
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
  // Modal damping is removed, because it refers to other modes at every speed.
  model::kit_of(machine)->damping_ratio = {0};
  const WhirlProblem problem(free_rotor(machine), scene::table_speeds_hz, 600);
  for (std::size_t row = 0; row < scene::table_speeds_hz.size(); ++row) {
    model::Machine typed = scene::typed_machine(row);
    model::kit_of(typed)->damping_ratio = {0};
    const double speed_hz = scene::table_speeds_hz[row];
    const auto found = problem.at(speed_hz).modes,
               expected = WhirlProblem(free_rotor(typed), scene::table_speeds_hz, 600).at(speed_hz).modes;
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_LT(std::abs(found[k].root_per_s - expected[k].root_per_s),
                1e-9 * std::abs(expected[k].root_per_s))
          << row << " " << k;
      EXPECT_NEAR(found[k].forward_share, expected[k].forward_share, 1e-8);
    }
  }
}

/// A mass of 1 kg with 20 Hz on a film whose damping is three times critical, but 0.99 times critical at 25
/// Hz. Beside it stand independent pairs of masses, the first one with 2 Hz, so that two modes are slow at
/// all speeds.
FreeRotor on_a_film(const std::vector<double>& speeds_hz, Eigen::Index beside) {
  const double rate = 2 * pi * 20;
  model::Support film = structure::isotropic_support(0, 0);
  model::SupportTable table;
  table.speed_hz = speeds_hz;
  for (const double hz : speeds_hz) {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      table.columns[c].push_back(c == 4 || c == 7 ? 2 * (hz == 25 ? 0.99 : 3) * rate : 0);
  }
  film.table = table;
  FreeRotor rotor;
  const Eigen::Index n = 2 + 2 * beside;
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n), one = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd rates = Eigen::VectorXd::LinSpaced(n, 2 * pi * 1000, 2 * pi * 3000);
  rates.head<2>().setConstant(rate);
  if (beside > 0) rates.segment<2>(2).setConstant(2 * pi * 2);
  rotor.full.system = {one, none, none, rates.cwiseAbs2().asDiagonal(), {n / 2, n / 2}};
  rotor.full.tables.push_back(structure::tabled_support(film));
  rotor.full.tables.front().map = one.topRows(2);
  rotor.spin = none;
  for (Eigen::Index i = 0; i < n; i += 2) rotor.spin(i, i + 1) = 1, rotor.spin(i + 1, i) = -1;
  return rotor;
}

void expect_the_pair_at_25_hz(const WhirlProblem& problem) {
  int strongly_damped = 0;
  for (const WhirlMode& mode : problem.at(25).modes) {
    if (mode.damping_ratio() < 0.5) continue;
    ++strongly_damped;
    EXPECT_NEAR(mode.damping_ratio(), 0.99, 1e-9);
    EXPECT_NEAR(mode.frequency_hz(), 20 * std::sqrt(1 - 0.99 * 0.99), 1e-7);
  }
  EXPECT_EQ(strongly_damped, 2);
  for (const WhirlMode& mode : problem.at(50).modes) EXPECT_LT(mode.damping_ratio(), 0.5);
}

TEST(WhirlModes, ThatStrongDampersLeaveAtOneSpeedOnlyAreFoundThere) {
  const FreeRotor rotor = on_a_film({10, 20, 25, 30, 50, 90}, 0);
  expect_the_pair_at_25_hz(WhirlProblem(rotor, std::vector<double>{10, 25, 50, 75, 90}, 4));
}

/// All eigenvalues are computed at six of eleven speeds; 25 Hz lies between two of these.
TEST(WhirlModes, AreFoundBetweenTheSpeedsAtWhichAllRatesAreLookedAt) {
  const std::vector<double> speeds_hz{0, 5, 10, 15, 20, 25, 30, 50, 60, 75, 90};
  expect_the_pair_at_25_hz(WhirlProblem(on_a_film(speeds_hz, 89), speeds_hz, 4));
}

/// Expects the roots up to `up_to_hz`, ascending by frequency, to be exactly those of the exported matrices.
/// Modal damping is removed, because matrix files do not contain it.
void expect_all_roots(model::Machine machine, double speed_hz, double up_to_hz) {
  model::kit_of(machine)->damping_ratio = {0};
  model::kit_of(machine)->elements = 4;  // the determinant of many elements is expensive
  const std::vector<double> speeds{speed_hz};
  const ExportedMatrices exported(machine, 2 * pi * speed_hz);
  int count = 0;
  for (const WhirlMode& mode : WhirlProblem(free_rotor(machine), speeds, up_to_hz).at(speed_hz).modes) {
    if (mode.frequency_hz() > up_to_hz || mode.frequency_hz() < 1e-3 * up_to_hz) continue;
    ++count;
    EXPECT_LT(std::abs(exported.root_near(mode.root_per_s) - mode.root_per_s),
              1e-9 * std::abs(mode.root_per_s))
        << mode.root_per_s;
  }
  EXPECT_EQ(count, exported.roots_below(2 * pi * up_to_hz)) << speed_hz << " " << up_to_hz;
  EXPECT_GT(count, 0);
}

TEST(WhirlModes, AreAllRootsOfTheExportedMatrices) {
  expect_all_roots(coupled_machine(), 70, 350);
  model::Machine damped_by_its_mass = coupled_machine();
  model::kit_of(damped_by_its_mass)->mass_damping_per_s = 12;
  model::kit_of(damped_by_its_mass)->shaft.front().stiffness_damping_s = 1e-6;
  expect_all_roots(damped_by_its_mass, 20, 200);
}

/// Strong dampers fix the shaft at its bearings: vibrations there are almost critically damped, so the
/// eigenvalue's modulus is far from its frequency.
TEST(WhirlModes, AreFoundHoweverDamped) {
  for (const double damping : {3e3, 1e5}) {
    model::Machine machine = coupled_machine();
    for (auto& support : model::kit_of(machine)->supports) {
      support.damping_x_ns_per_m = damping;
      support.damping_y_ns_per_m = 1.1 * damping;
    }
    expect_all_roots(machine, 60, 100);
  }
}

TEST(WhirlModes, SolveTheEquationsOfMotion) {
  const FreeRotor rotor = free_rotor(coupled_machine());
  const structure::LateralSystem& system = rotor.full.system;
  const double speed_hz = 70;
  const auto modes = WhirlProblem(rotor, std::vector{speed_hz}, 400).at(speed_hz).modes;
  ASSERT_GE(modes.size(), 8u);
  const Eigen::MatrixXd damping = system.damping + 2 * pi * speed_hz * system.gyroscopic;
  for (std::size_t k = 0; k < 8; ++k) {
    const Complex root = modes[k].root_per_s;
    const Eigen::VectorXcd q = modes[k].shape;
    const Eigen::VectorXcd elastic = system.stiffness.cast<Complex>() * q;
    const Eigen::VectorXcd rest =
        root * root * (system.mass.cast<Complex>() * q) + root * (damping.cast<Complex>() * q) + elastic;
    EXPECT_LT(rest.norm(), 1e-9 * elastic.norm()) << k;
    EXPECT_GE(root.imag(), modes[k > 0 ? k - 1 : 0].root_per_s.imag());
  }
}

/// Supports without damping, equal or coupled: nothing grows, and rounding must not count as growth.
TEST(WhirlModes, OfConservativeRotorsDoNotGrow) {
  for (const double coupling : {0.0, 2e5}) {
    model::Machine machine = coupled_machine();
    model::RotorKit& kit = *model::kit_of(machine);
    kit.damping_ratio = {0};
    for (auto& support : kit.supports) {
      support.damping_x_ns_per_m = 0;
      support.stiffness_xy_n_per_m = support.stiffness_yx_n_per_m = coupling;
    }
    const WhirlProblem problem(free_rotor(machine), std::vector<double>{0, 50, 400}, 400);
    for (const double speed_hz : {0.0, 33.0, 400.0}) {
      const WhirlModes found = problem.at(speed_hz);
      EXPECT_EQ(found.growth_per_s, 0);
      for (const WhirlMode& mode : found.modes) EXPECT_GE(mode.damping_ratio(), 0);
    }
  }
}

/// A very small cross stiffness without damping: a mode of stiffness k grows at the rate w kxy / (2 k).
TEST(WhirlModes, OfTheLeastForceAcrossGrow) {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 1, .natural_frequency_hz = 30, .damping_ratio = 0};
  FreeRotor rotor = free_rotor(machine);
  const double across = 1e-7 * rotor.full.system.stiffness(0, 0);
  rotor.full.system.stiffness(0, 1) = across;
  rotor.full.system.stiffness(1, 0) = -across;
  EXPECT_NEAR(WhirlProblem(rotor, std::vector<double>{10}, 100).at(10).growth_per_s, 60 * pi * 1e-7 / 2,
              1e-6 * 60 * pi * 1e-7);
}

TEST(WhirlModes, DirectionIsThatOfTheOrbits) {
  const FreeRotor rotor = free_rotor(coupled_machine());
  for (const WhirlMode& mode : WhirlProblem(rotor, std::vector<double>{70}, 300).at(70).modes) {
    if (mode.frequency_hz() > 300) break;
    // z = x + iy consists of a forward part (x + iy) / 2 and a backward part (x* + iy*) / 2.
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
}  // namespace rubsweep::linear
