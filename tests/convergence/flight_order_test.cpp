// Order of every stepper without mode changes, measured with fixed steps on a forced oscillator with a closed
// form. The force depends on time, so that wrong time derivatives or nodes are detected, too.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using adaptive::State;
using run::Stepper;
using Complex = std::complex<double>;
constexpr double two_pi = 2 * std::numbers::pi;

/// A revolution of 1 s, natural frequency 1.7 Hz, 5 % damping; unbalance force of 30 N/kg.
scene::Scene forced_scene() {
  const double w0 = 1.7 * two_pi;
  auto scene = test::one_mass_scene(1, w0 * w0, 2 * 0.05 * w0, 1, 1);
  scene.harmonic_n << 30, Complex(0, -30);
  scene.displacement_m << 0.3, 0.1;
  return scene;
}

/// Closed-form displacement z at `phase` of the first revolution.
Complex exact(double phase) {
  const double w = two_pi, w0 = 1.7 * w, decay = 0.05 * w0, wd = std::sqrt(w0 * w0 - decay * decay),
               t = phase / w;
  const Complex i(0, 1), amplitude = 30.0 / Complex(w0 * w0 - w * w, 2 * decay * w);
  const Complex z0 = Complex(0.3, 0.1) - amplitude, v0 = -i * w * amplitude;
  return amplitude * std::exp(i * phase) +
         std::exp(-decay * t) * (z0 * std::cos(wd * t) + (v0 + decay * z0) / wd * std::sin(wd * t));
}

template <class State>
double error_of(const State& state, double phase) {
  return std::abs(Complex(state[0], state[1]) - exact(phase));
}

struct Fixed {
  run::ScaledSystem<2> system = run::scale<2>(forced_scene());
  law::Dynamics<2, false> dynamics{system, 0};
  adaptive::LawOfSteps<law::Dynamics<2, false>> right_hand_side{dynamics};
  std::unique_ptr<adaptive::StepMethod> method;
  adaptive::Step step;

  explicit Fixed(Stepper stepper)
      // Every step is accepted, so its size is that of the test.
      : method(adaptive::make_step_method({.stepper = stepper, .relative_tolerance = 1e30})) {
    const auto initial = run::scaled_initial_state(forced_scene());
    for (State* s : {&step.start, &step.start_rate, &step.end, &step.end_rate}) *s = State(4);
    std::copy(initial.begin(), initial.end(), step.start.begin());
    dynamics(step.start, step.start_rate, 0.0);
  }

  void take(double h) {
    double size = h;
    ASSERT_TRUE(method->try_step(right_hand_side, step, size));
  }

  double error_after_a_turn(int steps) {
    const double h = two_pi / steps;
    for (int k = 0; k < steps; ++k) {
      step.start_phase = k * h;
      take(h);
      step.start = step.end;
      step.start_rate = step.end_rate;
    }
    return error_of(step.end, two_pi);
  }

  double error_inside_first_step(double h) {
    take(h);
    State inside(4);
    double largest = 0;
    for (const double x : {0.2, 0.45, 0.7}) {
      method->state_at(right_hand_side, step, x * h, inside);
      largest = std::max(largest, error_of(inside, x * h));
    }
    return largest;
  }
};

double global_order(Stepper stepper, int steps) {
  const double coarse = Fixed(stepper).error_after_a_turn(steps);
  const double fine = Fixed(stepper).error_after_a_turn(2 * steps);
  return std::log2(coarse / fine);
}

/// Order of the local error inside a step, one more than the order of the interpolant.
double inner_order(Stepper stepper, double h) {
  return std::log2(Fixed(stepper).error_inside_first_step(h) / Fixed(stepper).error_inside_first_step(h / 2));
}

TEST(FlightOrder, OfWholeSteps) {
  EXPECT_NEAR(global_order(Stepper::dopri5, 128), 5, 0.2);
  EXPECT_NEAR(global_order(Stepper::cash_karp54, 128), 5, 0.2);
  EXPECT_NEAR(global_order(Stepper::rkf78, 32), 8, 0.4);
  EXPECT_NEAR(global_order(Stepper::rosenbrock4, 256), 4, 0.2);
}

TEST(FlightOrder, OfStatesInsideAStep) {
  EXPECT_NEAR(inner_order(Stepper::dopri5, 0.05), 5, 0.3);       // dense output of order 4
  EXPECT_NEAR(inner_order(Stepper::cash_karp54, 0.05), 6, 0.5);  // the method itself
  EXPECT_GT(inner_order(Stepper::rkf78, 0.4), 8.4);
  EXPECT_NEAR(inner_order(Stepper::rosenbrock4, 0.05), 4, 0.3);  // dense output of order 3
}

TEST(FlightOrder, BulirschStoerFollowsItsTolerance) {
  // This stepper has no fixed order: its error must follow the tolerance, while its cost hardly changes.
  run::SolverOptions options;
  options.stepper = run::Stepper::bulirsch_stoer;
  std::vector<double> errors, calls;
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    options.relative_tolerance = tolerance;
    run::TurnReport turn;
    ASSERT_EQ(adaptive::start_adaptive(forced_scene(), options)({}, turn), run::Outcome::ok);
    errors.push_back(error_of(turn.section, two_pi));
    calls.push_back(static_cast<double>(turn.effort.rhs_calls));
  }
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_LT(errors[1], 1e-2 * errors[0]);
  EXPECT_LT(errors[2], 1e-11);
  EXPECT_GT(std::log(errors[0] / errors[2]) / std::log(calls[2] / calls[0]), 8);
}

}  // namespace
}  // namespace rubsweep::integrate
