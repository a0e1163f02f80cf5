// The energy balance of whole traces: what kinetic, elastic and contact energy gain is the integral of the
// powers, by the trapezoidal rule over the samples.
#include "rubsweep/trace/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/contact/force_law.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/trace/trace_run.hpp"
#include "scene/kit_machine.hpp"
#include "support/annular_scene.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::trace {
namespace {

struct Balance {
  double gap_j = 0;   ///< largest difference between energy and work so far
  double work_j = 0;  ///< integral of the powers without their signs
  double friction_j = 0, sticking_j = 0;
  double held_n = 0;  ///< largest friction below its limit
};

double power_w(const Energy& e) { return e.forcing_w + e.damping_w + e.contact_damping_w + e.friction_w; }
double total_j(const Energy& e) { return e.kinetic_j + e.elastic_j + e.contact_j; }

Balance balance_of(const scene::Scene& scene, int samples, long turns,
                   const integrate::run::SolverOptions& solver = {}) {
  integrate::exact::modes::ModeCache modes;
  const TraceOptions options{.speed_hz = 1 / scene.period_s(),
                             .revolutions = turns,
                             .samples_per_revolution = samples,
                             .window_revolutions = 1,
                             .trajectory_revolutions = {}};
  const Trace trace = trace_run(integrate::start(scene, solver, modes).advance, scene, solver, options);
  EXPECT_EQ(trace.outcome, integrate::run::Outcome::ok);
  Balance balance;
  double work_j = 0;
  const auto& states = trace.trajectory;
  for (std::size_t k = 1; k < states.size(); ++k) {
    const Energy &a = states[k - 1].state.energy, &b = states[k].state.energy;
    const double h = (states[k].time_s - states[k - 1].time_s) / 2;
    work_j += h * (power_w(a) + power_w(b));
    balance.friction_j += h * (a.friction_w + b.friction_w);
    for (const Energy* e : {&a, &b}) {
      balance.work_j += h * (std::abs(e->forcing_w) + std::abs(e->damping_w) +
                             std::abs(e->contact_damping_w) + std::abs(e->friction_w));
    }
    balance.gap_j = std::max(balance.gap_j, std::abs(total_j(b) - total_j(states[0].state.energy) - work_j));
    for (const StopState& stop : states[k].state.stops) {
      const double friction = std::abs(stop.friction_force_n);
      if (friction < 0.099 * stop.normal_force_n) balance.held_n = std::max(balance.held_n, friction);
    }
  }
  return balance;
}

/// The rule is of second order, also over the corners of the powers.
void expect_closed(const scene::Scene& scene, long turns, const integrate::run::SolverOptions& solver = {}) {
  const Balance coarse = balance_of(scene, 4096, turns, solver),
                fine = balance_of(scene, 16384, turns, solver);
  EXPECT_LT(coarse.gap_j, 2e-4 * coarse.work_j);
  EXPECT_LT(fine.gap_j, coarse.gap_j / 8);
}

TEST(EnergyBalance, ClosesAtAFlatStopWithItsCasing) {
  const scene::Scene scene = test::cell_of({}).scene;
  expect_closed(scene, 12);
  EXPECT_GT(std::abs(balance_of(scene, 4096, 12).friction_j), 1e-4);
}

TEST(EnergyBalance, ClosesInASmoothedLaw) {
  const integrate::run::SolverOptions smoothed{
      .contact = integrate::run::ContactHandling::smoothed, .relative_tolerance = 1e-11, .smoothing_m = 1e-6};
  expect_closed(test::cell_of({}).scene, 6, smoothed);
}

TEST(EnergyBalance, ClosesInAnOffsetAnnularStopWithDryFriction) {
  scene::Scene scene = test::annular_scene(1, 0.05, 1.3, 0.6, {0.1, -0.2}, 40, 0);
  scene.contacts[0].wall = contact::AnnularWall{{0.1, 0.05}};
  scene.contacts[0].friction = model::ConstantFriction{0.1};
  scene.contacts[0].damping_ns_per_m = 0.7;
  scene.contacts[0].surface_speed_m_per_s = 0.4;
  expect_closed(scene, 12);
  EXPECT_GT(std::abs(balance_of(scene, 4096, 12).friction_j), 0.1);
}

TEST(EnergyBalance, ClosesWhereDryFrictionHoldsARotorOnItsCasing) {
  // Pressed on a floor that moves, whose surface stands still, by 5 N; shaken along it by less than 0.5 N
  // at first, more beside the kick.
  scene::Scene scene = test::cell_of({.kick_n = 0, .whirl_ratio = 0}).scene;
  scene.contacts[0].friction = model::ConstantFriction{0.1};
  scene.contacts[0].surface_speed_m_per_s = 0;
  scene.constant_n(1) += 40;
  scene.harmonic_n(0) = 3;
  scene.displacement_m(1) = 0.9e-3;
  scene.velocity_m_per_s.setZero();
  expect_closed(scene, 16);
  EXPECT_GT(balance_of(scene, 1024, 16).held_n, 0.1);
}

TEST(EnergyBalance, ClosesForARotorKitByItsCoordinates) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.shaft[0].density_kg_per_m3 = 7800;
  kit.modes = 3;
  kit.supports[0].stiffness_xy_n_per_m = 2e3;
  kit.supports[0].stiffness_yx_n_per_m = -2e3;
  kit.supports[1].damping_x_ns_per_m = 30;
  machine.gravity_m_per_s2 = 9.81;
  const scene::Cell cell = scene::build_cell(machine, 60, scene::WhirlRatio{0.5});
  expect_closed(cell.scene, 12);
}

TEST(EnergyBalance, ClosesWithAForceOfTwiceTheSpeed) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.second_harmonic_n = std::polar(0.6, 0.4) * scene.harmonic_n.conjugate();
  expect_closed(scene, 12);
}

TEST(EnergyBalance, HasNoForcingBesideTorsion) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.twist.emplace();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(4);
  EXPECT_TRUE(std::isnan(structure_energy(scene, zero, zero, 0).forcing_w));
}

TEST(EnergySpring, IsTheIntegralOfTheSpringForce) {
  constexpr double stiffness = 3e6, width = 2e-6;
  for (const double smoothing : {0.0, width}) {
    double sum = 0;
    constexpr int steps = 20000;
    constexpr double from = -2e-6, step = 6e-6 / steps;
    const auto force = [&](double p) {
      return smoothing > 0 ? contact::smoothed_elastogap(stiffness, 0, p, 0, smoothing).spring_n
                           : contact::elastogap(stiffness, 0, p, 0).spring_n;
    };
    for (int k = 0; k < steps; ++k) {
      sum += step * (force(from + k * step) + force(from + (k + 1) * step)) / 2;
      EXPECT_NEAR(spring_energy_j(stiffness, from + (k + 1) * step, smoothing), sum, 1e-12);
    }
  }
}

}  // namespace
}  // namespace rubsweep::trace
