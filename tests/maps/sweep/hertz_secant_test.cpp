#include "rubsweep/maps/sweep/hertz_secant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

using std::numbers::pi;

constexpr double within_tolerance = contact::hertz_secant_tolerance + 1e-12;

/// Steel on flat brass, linearised at a force far below the forces of the tests.
model::HertzLine steel_on_brass(double design_force_n) {
  return {.length_m = 0.006,
          .rotor = {.radius_m = 5e-3, .youngs_modulus_pa = 2.06e11, .poisson_ratio = 0.3},
          .casing = {.youngs_modulus_pa = 1.03e11, .poisson_ratio = 0.34},
          .casing_shape = model::HertzShape::flat,
          .design_force_n = design_force_n};
}

void make_rigid_and_frictionless(model::Stop& stop, double design_force_n) {
  stop.hertz = steel_on_brass(design_force_n);
  stop.stiffness_n_per_m = contact::hertz_stiffness_n_per_m(*stop.hertz);
  stop.casing.reset();
  stop.friction = model::NoFriction{};
  stop.contact_radius_m = 0.005;
}

/// A study of the one-side machine with such a stop.
Study study_with(double design_force_n, int iterations) {
  Study study = one_side_study({75}, {0.4});
  make_rigid_and_frictionless(study.machine.stops[0], design_force_n);
  study.hertz_iterations = iterations;
  return study;
}

Row row_with_force(double force_n) {
  Row row;
  row.start = RunStart::kick;
  row.measures.emplace().contact.peak_contact_force_n = force_n;
  return row;
}

/// Force at which `force_of(stiffness)` equals the force of the secant stiffness, by bisection.
template <class ForceOf>
double fixed_point_n(const model::HertzLine& contact, const ForceOf& force_of, double low_n, double high_n) {
  const auto excess = [&](double force_n) {
    return force_of(*contact::hertz_secant_n_per_m(contact, force_n)) - force_n;
  };
  const auto [low, high] =
      boost::math::tools::bisect(excess, low_n, high_n, [](double a, double b) { return b - a < 1e-9 * b; });
  return (low + high) / 2;
}

TEST(HertzSecant, ComesToTheFixedPointOfAKnownForce) {
  // Impact of a mass: F = speed sqrt(mass K).
  const Study study = study_with(20, 6);
  const model::HertzLine& contact = *study.machine.stops[0].hertz;
  const auto force_of = [](double stiffness) { return 0.3 * std::sqrt(0.8 * stiffness); };
  int runs = 0;
  const Row row =
      with_hertz_iterations(study.machine, study.hertz_iterations, [&](const model::Machine& machine) {
        ++runs;
        return row_with_force(force_of(machine.stops[0].stiffness_n_per_m));
      });
  const double fixed_n = fixed_point_n(contact, force_of, 20, 1e5);
  ASSERT_TRUE(row.hertz);
  EXPECT_GE(row.hertz->iterations, 1);
  EXPECT_EQ(runs, row.hertz->iterations + 1);
  EXPECT_EQ(row.status, "ok");
  EXPECT_NEAR(row.hertz->stiffness_n_per_m / *contact::hertz_secant_n_per_m(contact, fixed_n), 1,
              within_tolerance);
  EXPECT_NEAR(row.measures->contact.peak_contact_force_n / fixed_n, 1, within_tolerance / 2);
}

TEST(HertzSecant, NothingIsRunAgainWithinTheRangeOrWithoutContact) {
  const Study study = study_with(20, 6);
  const auto same = [&](double force_n) {
    return with_hertz_iterations(study.machine, study.hertz_iterations,
                                 [&](const model::Machine&) { return row_with_force(force_n); });
  };
  for (const double force_n :
       {0.0, 1.0, 20.0, 0.99 * contact::hertz_force_limit_n(*study.machine.stops[0].hertz)}) {
    const Row row = same(force_n);
    EXPECT_EQ(row.hertz->iterations, 0) << force_n;
    EXPECT_EQ(row.hertz->force_n, 20);
    EXPECT_EQ(row.hertz->stiffness_n_per_m, study.machine.stops[0].stiffness_n_per_m);
  }
  EXPECT_EQ(same(1.01 * contact::hertz_force_limit_n(*study.machine.stops[0].hertz)).hertz->iterations, 1);
}

TEST(HertzSecant, AnotherProgramMakesTheMachineOfARowFromItsForce) {
  Study study = study_with(100, 3);
  study.machine.stops.push_back(study.machine.stops[0]);
  make_rigid_and_frictionless(study.machine.stops[1], 10);
  for (const double force_n : {0.0, 50.0, 200.0, 800.0}) {
    model::Machine used;
    const Row row =
        with_hertz_iterations(study.machine, study.hertz_iterations, [&](const model::Machine& machine) {
          used = machine;
          return row_with_force(force_n);
        });
    scene::PreparedMachine prepared;
    prepared.machine = study.machine;
    const model::Machine again = with_secant_of_row(prepared, row.hertz->force_n).machine;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(again.stops[i].stiffness_n_per_m, used.stops[i].stiffness_n_per_m)
          << force_n << " N, stop " << i;
  }
}

TEST(HertzSecant, SaysSoWhereItDoesNotCome) {
  // A force that alternates between two values, and a force that makes the contact wider than long.
  const Study study = study_with(20, 3);
  int runs = 0;
  const Row jumping = with_hertz_iterations(
      study.machine, study.hertz_iterations,
      [&](const model::Machine&) { return row_with_force(runs++ % 2 == 0 ? 2000 : 25); });
  EXPECT_EQ(jumping.status, "beyond_hertz");
  EXPECT_EQ(jumping.hertz->iterations, 3);
  EXPECT_EQ(runs, 4);
  const Row wide = with_hertz_iterations(study.machine, study.hertz_iterations,
                                         [](const model::Machine&) { return row_with_force(1e9); });
  EXPECT_EQ(wide.status, "beyond_hertz");
  EXPECT_EQ(wide.hertz->iterations, 0);
  EXPECT_FALSE(takes_secants_anew(study_with(20, 0)));
  EXPECT_TRUE(takes_secants_anew(study));
}

/// Full annular rub in a frictionless rigid ring: the modulus of (k - m w^2 + i c w) r + K (r - C) equals m e
/// w^2.
TEST(HertzSecant, FullAnnularRubHasTheForceOfItsOwnSecant) {
  Study study = study_with(1, 4);
  study.machine.stops[0].geometry = model::AnnularGeometry{};
  study.machine.stops[0].hertz->casing_shape = model::HertzShape::hole;
  study.machine.stops[0].hertz->casing.radius_m = 0.006;
  study.machine.stops[0].stiffness_n_per_m = contact::hertz_stiffness_n_per_m(*study.machine.stops[0].hertz);
  study.machine.kick.reset();
  study.grid.speed_hz = {25};
  study.grid.unbalance = {1.8};
  study.response.max_revolutions = 400;
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  ASSERT_EQ(to_string(row.motion_class), "synchronous");
  ASSERT_TRUE(row.hertz);
  EXPECT_GE(row.hertz->iterations, 1);
  const double w = 2 * pi * 25, w0 = 2 * pi * 30, m = 0.8, c = 2 * 0.02 * m * w0;
  const double clearance = study.machine.stops[0].clearance_m;
  const auto force_of = [&](double stiffness) {
    const auto excess = [&](double r) {
      const std::complex<double> left(m * (w0 * w0 - w * w) * r + stiffness * (r - clearance), c * w * r);
      return std::abs(left) - m * row.eccentricity_m * w * w;
    };
    const auto [low, high] = boost::math::tools::bisect(excess, clearance, 2 * clearance,
                                                        [](double a, double b) { return b - a < 1e-16; });
    return stiffness * ((low + high) / 2 - clearance);
  };
  const double force_n = row.measures->contact.peak_contact_force_n;
  EXPECT_NEAR(force_n, force_of(row.hertz->stiffness_n_per_m), 1e-6 * force_n);
  const double fixed_n = fixed_point_n(*study.machine.stops[0].hertz, force_of, 1, 1000);
  EXPECT_NEAR(force_n, fixed_n, 1e-2 * fixed_n);
  EXPECT_NEAR(
      row.hertz->stiffness_n_per_m / *contact::hertz_secant_n_per_m(*study.machine.stops[0].hertz, fixed_n),
      1, within_tolerance);
}

/// Largest force in one turn from the kick on, with the machine's constant stiffness.
double linear_force_n(const model::Machine& machine) {
  const scene::Cell cell = scene::build_cell(machine, 75, scene::WhirlRatio{0.4});
  response::motion::Workspace workspace;
  integrate::run::TurnReport turn;
  const auto run = integrate::start(cell.scene, {}, workspace.modes);
  EXPECT_EQ(run.advance({.peaks = true}, turn), integrate::run::Outcome::ok);
  return turn.peak_contact_force_n;
}

/// The same turn with the nonlinear force of Hertz' approach, by Odeint: only y moves, against a frictionless
/// wall above the rotor.
double nonlinear_force_n(const model::HertzLine& contact) {
  const double w = 2 * pi * 75, w0 = 2 * pi * 30, m = 0.8, c = 2 * 0.02 * m * w0, k = m * w0 * w0;
  const double clearance = 1e-3, whirl = 0.4 * clearance;
  const auto force_of = [&](double penetration) {
    if (penetration <= 0) return 0.0;
    // The approach increases with the force; every force is below this bound from the stiffest secant.
    double low = 0, high = 4e8 * penetration;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (contact::hertz_approach_m(contact, middle) < penetration ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  using State = std::array<double, 2>;
  const auto rate = [&](const State& s, State& ds, double t) {
    const double unbalance = (k - m * w * w) * whirl * std::cos(w * t) - c * w * whirl * std::sin(w * t);
    const double kick = t < 0.005 ? 200 * std::sin(pi * t / 0.005) : 0;
    ds = {s[1], (unbalance + kick - c * s[1] - k * s[0] - force_of(s[0] - clearance)) / m};
  };
  double largest = 0;
  State state{whirl, 0};
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(1e-12, 1e-10), rate, state, 0.0, 1.0 / 75,
      1e-6, [&](const State& s, double) { largest = std::max(largest, force_of(s[0] - clearance)); });
  return largest;
}

TEST(HertzSecant, IsNearerToTheNonlinearContactThanTheDesignForceIs) {
  Study study = study_with(5, 4);
  study.machine.stops[0].damping = model::ExplicitDamping{0};
  const Row row = with_hertz_iterations(
      study.machine, study.hertz_iterations,
      [](const model::Machine& machine) { return row_with_force(linear_force_n(machine)); });
  const double nonlinear_n = nonlinear_force_n(*study.machine.stops[0].hertz);
  const double at_design_n = linear_force_n(study.machine);
  EXPECT_GE(row.hertz->iterations, 1);
  EXPECT_NEAR(row.measures->contact.peak_contact_force_n, nonlinear_n, 0.05 * nonlinear_n);
  EXPECT_GT(std::abs(at_design_n - nonlinear_n), 0.1 * nonlinear_n);
}

}  // namespace
}  // namespace rubsweep::sweep
