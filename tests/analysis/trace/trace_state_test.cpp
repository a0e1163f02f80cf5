#include "rubsweep/analysis/trace/trace_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/annular_scene.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::trace {
namespace {

using test::OneSideEquations;
using test::OneSideRotor;
using test::OneSideState;

constexpr integrate::run::SolverOptions located{};
constexpr integrate::run::SolverOptions smoothed{.contact = integrate::run::ContactHandling::smoothed,
                                                 .smoothing_m = 1e-6};

/// Converts a state from SI units to the scaled units of a run.
std::vector<double> scaled(const OneSideState<double>& state, const OneSideRotor& rotor) {
  const double speed = 2 * std::numbers::pi * rotor.speed_hz;
  std::vector<double> result;
  for (std::size_t i = 0; i < 8; ++i) result.push_back(state[i] / rotor.clearance_m / (i < 4 ? 1 : speed));
  return result;
}

/// A rotor close to the wall, in contact or just released, with random velocity.
OneSideState<double> near_the_wall(std::mt19937& random) {
  std::normal_distribution<double> place(0, 2e-4), speed(0, 0.5);
  OneSideState<double> state{place(random), 1.1e-3 + place(random), place(random), place(random)};
  for (std::size_t i = 4; i < 8; ++i) state[i] = speed(random);
  return state;
}

TEST(TraceStateReader, GivesTheForcesThatTheEquationsOfMotionNeed) {
  // The slip has both signs, and the friction depends on it.
  const OneSideRotor rotor{.contact_radius_m = 0.0005, .friction_steepness_s_per_m = 2};
  const OneSideEquations<double> equations(rotor);
  const scene::Cell cell = test::cell_of(rotor);
  const StateReader reader(cell.scene, located);
  std::mt19937 random(1);
  int touching = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const OneSideState<double> s = near_the_wall(random);
    OneSideState<double> rate;
    equations(s, rate, 1.0);
    // Force on the casing without its own spring and damper; the tangent is (-1, 0).
    const double normal_n = equations.mc * rate[7] + equations.kc * s[3] + equations.cc * s[7];
    const double friction_n = -(equations.mc * rate[6] + equations.kc * s[2] + equations.cc * s[6]);

    const TraceState state = reader.read(scaled(s, rotor), 0);
    ASSERT_EQ(state.stops.size(), 1u);
    EXPECT_NEAR(state.displacement_m.x(), s[0], 1e-18);
    EXPECT_NEAR(state.displacement_m.y(), s[1], 1e-18);
    EXPECT_NEAR(state.velocity_m_per_s.x(), s[4], 1e-15);
    EXPECT_NEAR(state.velocity_m_per_s.y(), s[5], 1e-15);
    EXPECT_NEAR(state.stops[0].casing_m.x(), s[2], 1e-18);
    EXPECT_NEAR(state.stops[0].casing_m.y(), s[3], 1e-18);
    EXPECT_NEAR(state.stops[0].gap_m, -equations.penetration(s), 1e-17);
    EXPECT_NEAR(state.stops[0].normal_force_n, normal_n, 1e-9);
    EXPECT_NEAR(state.stops[0].friction_force_n, friction_n, 1e-9);
    touching += state.stops[0].normal_force_n > 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 500);
  EXPECT_LT(touching, 1500);
}

TEST(TraceStateReader, SmoothedLawDiffersAtTheCornersOnly) {
  const OneSideRotor rotor;
  const scene::Cell cell = test::cell_of(rotor);
  const StateReader sharp(cell.scene, located), soft(cell.scene, smoothed);
  OneSideState<double> state{};
  const auto force_at = [&](const StateReader& reader, double penetration_m) {
    state[1] = rotor.clearance_m + penetration_m;
    return reader.read(scaled(state, rotor), 0).stops[0].normal_force_n;
  };
  EXPECT_EQ(force_at(sharp, 0), 0);
  EXPECT_NEAR(force_at(soft, 0), rotor.stiffness_n_per_m * 1e-6 / 8, 1e-9);  // smoothed: a parabola near 0
  EXPECT_NEAR(force_at(soft, 1e-4), force_at(sharp, 1e-4), 1e-9);
  EXPECT_EQ(force_at(soft, -1e-4), 0);
}

/// A mass at rest in a rigid annular stop with its centre at (-3e-4, -4e-4).
scene::Scene annular_scene() {
  scene::Scene scene = test::one_mass_scene(1, 1000, 0, 0.02, 1e-3);
  scene::Contact stop;
  stop.wall = contact::AnnularWall{{3e-4, 4e-4}};
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 1e6;
  stop.damping_ns_per_m = 100;
  stop.friction = model::ConstantFriction{0.2};
  stop.surface_speed_m_per_s = 2;
  scene.contacts.push_back(stop);
  return scene;
}

TEST(TraceStateReader, ShowsWhatHoldsAContactThatSticks) {
  scene::Scene scene = annular_scene();
  // The shaft's spring acts along the normal; a rotating force acts along the tangent (-0.8, 0.6) at first,
  // and against it half a turn later.
  const Eigen::Vector2d tangent(-0.8, 0.6);
  scene.harmonic_n = (70.0 * tangent).cast<std::complex<double>>();
  scene.constant_n = 20 * tangent;
  const StateReader reader(scene, located);
  const double speed = scene.speed_rad_per_s;
  // The rotor moves with the surface, at -2 m/s along the tangent, so it sticks.
  const std::vector<double> sticking{0.6, 0.8, 1.6 / (1e-3 * speed), -1.2 / (1e-3 * speed)};
  EXPECT_NEAR(reader.read(sticking, 0).stops.at(0).normal_force_n, 500, 1e-9);
  EXPECT_NEAR(reader.read(sticking, 0).stops.at(0).friction_force_n, 90, 1e-7);
  EXPECT_NEAR(reader.read(sticking, 7.5).stops.at(0).friction_force_n, -50, 1e-7);
  EXPECT_NEAR(reader.read(sticking, 0.25).stops.at(0).friction_force_n, 20, 1e-7);
  // At its peak a kick of 60 N exceeds friction: the contact begins to slip forward.
  scene.pulses.push_back({.direction = tangent, .force_n = 60, .duration_s = 2 * scene.period_s()});
  const StateReader kicked(scene, located);
  EXPECT_NEAR(kicked.read(sticking, 1).stops.at(0).friction_force_n, 0.2 * 500, 1e-9);
  EXPECT_NEAR(kicked.read(sticking, 0.5).stops.at(0).friction_force_n, -50 + 60 * std::sqrt(0.5), 1e-7);
}

TEST(TraceStateReader, SmoothedDryFrictionIsThatOfTheEquationsOfMotion) {
  scene::Scene scene = annular_scene();
  const StateReader reader(scene, smoothed);
  const double speed = scene.speed_rad_per_s, slip_m_per_s = 1e-6 * speed;
  const std::vector<double> creeping{0.6, 0.8, -0.8 * (slip_m_per_s - 2) / (1e-3 * speed),
                                     0.6 * (slip_m_per_s - 2) / (1e-3 * speed)};
  EXPECT_NEAR(reader.read(creeping, 0).stops.at(0).friction_force_n, 0.2 * 500 * std::tanh(1), 1e-6);
}

TEST(TraceStateReader, ReadsARingAlongTheOffsetDisplacement) {
  const scene::Scene scene = annular_scene();
  const StateReader reader(scene, located);
  const double speed = scene.speed_rad_per_s;
  // d = (6, 8)e-4 + (3, 4)e-4 = 1.5e-3 along n = (0.6, 0.8); closing speed 1 m/s, sliding speed 0.5 m/s along
  // (-0.8, 0.6).
  const std::vector<double> touching{0.6, 0.8, (0.6 - 0.4) / (1e-3 * speed), (0.8 + 0.3) / (1e-3 * speed)};
  const StopState stop = reader.read(touching, 0).stops.at(0);
  EXPECT_NEAR(stop.gap_m, -5e-4, 1e-17);
  EXPECT_NEAR(stop.normal_force_n, 500 + 100, 1e-9);
  EXPECT_NEAR(stop.friction_force_n, 0.2 * 500, 1e-9);
  EXPECT_EQ(stop.casing_m, Eigen::Vector2d(0, 0));  // rigid

  // At the exact centre the normal is undefined, and nothing touches.
  const StopState centred = reader.read(std::vector<double>{-0.3, -0.4, 0, 0}, 0).stops.at(0);
  EXPECT_NEAR(centred.gap_m, 1e-3, 1e-18);
  EXPECT_EQ(centred.normal_force_n, 0);
  EXPECT_EQ(centred.friction_force_n, 0);
}

TEST(TraceStateReader, RefusesAStateOfAnotherSize) {
  const scene::Scene scene = annular_scene();
  const StateReader reader(scene, located);
  EXPECT_EQ(reader.size(), 4u);
  EXPECT_THROW(reader.read(std::vector<double>(3), 0), SolverError);
}

struct Balance {
  double gap_j = 0;   ///< largest difference between energy and accumulated work
  double work_j = 0;  ///< integral of the absolute powers
  double friction_j = 0, sticking_j = 0;
  double held_n = 0;  ///< largest friction force of a sticking contact
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

/// The integration rule has second order, even across corners of the powers.
void expect_closed(const scene::Scene& scene, long turns, const integrate::run::SolverOptions& solver = {}) {
  const Balance coarse = balance_of(scene, 4096, turns, solver),
                fine = balance_of(scene, 16384, turns, solver);
  EXPECT_LT(coarse.gap_j, 2e-4 * coarse.work_j);
  EXPECT_LT(fine.gap_j, coarse.gap_j / 8);
}

TEST(TraceStateBalance, ClosesAtAFlatStopWithItsCasing) {
  const scene::Scene scene = test::cell_of({}).scene;
  expect_closed(scene, 12);
  EXPECT_GT(std::abs(balance_of(scene, 4096, 12).friction_j), 1e-4);
}

TEST(TraceStateBalance, ClosesInASmoothedLaw) {
  const integrate::run::SolverOptions smooth_law{
      .contact = integrate::run::ContactHandling::smoothed, .relative_tolerance = 1e-11, .smoothing_m = 1e-6};
  expect_closed(test::cell_of({}).scene, 6, smooth_law);
}

TEST(TraceStateBalance, ClosesInAnOffsetAnnularStopWithDryFriction) {
  scene::Scene scene = test::annular_scene(1, 0.05, 1.3, 0.6, {0.1, -0.2}, 40, 0);
  scene.contacts[0].wall = contact::AnnularWall{{0.1, 0.05}};
  scene.contacts[0].friction = model::ConstantFriction{0.1};
  scene.contacts[0].damping_ns_per_m = 0.7;
  scene.contacts[0].surface_speed_m_per_s = 0.4;
  expect_closed(scene, 12);
  EXPECT_GT(std::abs(balance_of(scene, 4096, 12).friction_j), 0.1);
}

TEST(TraceStateBalance, ClosesWhereDryFrictionHoldsARotorOnItsCasing) {
  // A rotor pressed by 5 N onto a moving floor whose surface stands still, and shaken along it: by less than
  // 0.5 N at first, by more during the kick.
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

TEST(TraceStateBalance, ClosesForARotorKitByItsCoordinates) {
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

TEST(TraceStateBalance, ClosesWithAForceOfTwiceTheSpeed) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.second_harmonic_n = std::polar(0.6, 0.4) * scene.harmonic_n.conjugate();
  expect_closed(scene, 12);
}

TEST(TraceStateBalance, HasNoForcingBesideTorsion) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.twist.emplace();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(4);
  EXPECT_TRUE(std::isnan(structure_energy(scene, zero, zero, 0).forcing_w));
}

TEST(TraceStateSpring, IsTheIntegralOfTheSpringForce) {
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
