#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "rubsweep/integrate/adaptive/step.hpp"
#include "rubsweep/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// Every method below offers the same three calls on a Step whose start is filled in:
/// - `bool try_step(dynamics, step, size)` attempts a step of `size` radians. True: it was accepted, and the
///   step's `end`, `end_rate` and `end_phase` are filled. Either way `size` becomes the next size to try.
/// - `void state_at(dynamics, step, phase, out)` gives a state inside the last accepted step: by dense output
///   where the method has one, else by the same method again from the start of the step.
/// - `void restart()` says that the right-hand side has changed its form, at a change of contact mode or an
///   impulse: what the method remembers of earlier steps is of no use.
namespace odeint = boost::numeric::odeint;

template <class State>
odeint::default_error_checker<double, typename odeint::algebra_dispatcher<State>::algebra_type,
                              typename odeint::operations_dispatcher<State>::operations_type>
error_checker(double tolerance) {
  // |error| <= tolerance (1 + |x|): absolute in units of (clearance, clearance * speed), plus relative.
  return {tolerance, tolerance, 1.0, 0.0};
}

/// Dormand-Prince 5(4) with its dense output of order 4. (Hairer, Norsett, Wanner, Solving ODEs I, II.5-6.)
template <class StateType>
class Dopri5 {
 public:
  using State = StateType;
  explicit Dopri5(const run::SolverOptions& options)
      : stepper_(error_checker<State>(options.relative_tolerance)) {}

  template <class Dynamics>
  bool try_step(Dynamics& dynamics, Step<State>& step, double& size) {
    double phase = step.start_phase;
    const auto result = stepper_.try_step(std::ref(dynamics), step.start, step.start_rate, phase, step.end,
                                          step.end_rate, size);
    step.end_phase = phase;
    return result == odeint::success;
  }

  template <class Dynamics>
  void state_at(Dynamics&, const Step<State>& step, double phase, State& out) {
    stepper_.stepper().calc_state(phase, out, step.start, step.start_rate, step.start_phase, step.end,
                                  step.end_rate, step.end_phase);
  }

  void restart() {}

 private:
  odeint::controlled_runge_kutta<odeint::runge_kutta_dopri5<State>> stepper_;
};

/// Embedded Runge-Kutta pairs without dense output: cash_karp54, rkf78.
template <class ErrorStepper>
class ReStepping {
 public:
  using State = typename ErrorStepper::state_type;
  explicit ReStepping(const run::SolverOptions& options)
      : stepper_(error_checker<State>(options.relative_tolerance)) {}

  template <class Dynamics>
  bool try_step(Dynamics& dynamics, Step<State>& step, double& size) {
    double phase = step.start_phase;
    const auto result =
        stepper_.try_step(std::ref(dynamics), step.start, step.start_rate, phase, step.end, size);
    if (result != odeint::success) return false;
    step.end_phase = phase;
    dynamics(step.end, step.end_rate, phase);
    return true;
  }

  template <class Dynamics>
  void state_at(Dynamics& dynamics, const Step<State>& step, double phase, State& out) {
    out = step.start;
    stepper_.stepper().do_step(std::ref(dynamics), step.start, step.start_rate, step.start_phase, out,
                               phase - step.start_phase);
  }

  void restart() {}

 private:
  odeint::controlled_runge_kutta<ErrorStepper> stepper_;
};

/// Extrapolated midpoint rule of variable order. Odeint's dense variant cannot be stopped at a mode switch,
/// so states inside a step come from the same method run again from the step's start.
template <class StateType>
class BulirschStoer {
 public:
  using State = StateType;
  explicit BulirschStoer(const run::SolverOptions& options)
      : tolerance_(options.relative_tolerance), stepper_(tolerance_, tolerance_, 1.0, 0.0) {}

  template <class Dynamics>
  bool try_step(Dynamics& dynamics, Step<State>& step, double& size) {
    double phase = step.start_phase;
    step.end = step.start;
    const auto result =
        stepper_.try_step(std::ref(dynamics), step.start, step.start_rate, phase, step.end, size);
    if (result != odeint::success) return false;
    step.end_phase = phase;
    dynamics(step.end, step.end_rate, phase);
    return true;
  }

  template <class Dynamics>
  void state_at(Dynamics& dynamics, const Step<State>& step, double target, State& out) {
    odeint::bulirsch_stoer<State> stepper(tolerance_, tolerance_, 1.0, 0.0);
    out = step.start;
    State from = step.start, rate = step.start_rate;
    double phase = step.start_phase, size = target - phase;
    // The whole step satisfied the error control, so a part of it does at once or after a few halvings.
    for (int attempt = 0; attempt < 1000 && phase < target; ++attempt) {
      if (phase + size > target) size = target - phase;
      const bool last = phase + size == target;
      if (stepper.try_step(std::ref(dynamics), from, rate, phase, out, size) != odeint::success) continue;
      if (last) return;
      from = out;
      dynamics(from, rate, phase);
    }
    // A state on the way is no state at `target`: the run is to end where it does not get there.
    if (phase < target) std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  }

  void restart() { stepper_.reset(); }

 private:
  double tolerance_;
  odeint::bulirsch_stoer<State> stepper_;
};

/// Odeint's coefficients of RODAS with the sign of d4 put right: Boost 1.81 has +0.0362, which makes the
/// method first order as soon as the right-hand side depends on time (Hairer & Wanner, RODAS: D4 = -0.0362).
struct RodasCoefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;
};

/// Rosenbrock method of order 4 with dense output, for stiff friction. Uses the analytic Jacobian of the
/// dynamics.
class Rosenbrock4 {
 public:
  using State = boost::numeric::ublas::vector<double>;
  explicit Rosenbrock4(const run::SolverOptions& options)
      : stepper_(options.relative_tolerance, options.relative_tolerance) {}

  template <class Dynamics>
  bool try_step(Dynamics& dynamics, Step<State>& step, double& size) {
    double phase = step.start_phase;
    const auto result = stepper_.try_step(implicit_system(dynamics), step.start, phase, step.end, size);
    if (result != odeint::success) return false;
    step.end_phase = phase;
    dynamics(step.end, step.end_rate, phase);
    dense_ready_ = false;
    return true;
  }

  template <class Dynamics>
  void state_at(Dynamics&, const Step<State>& step, double phase, State& out) {
    if (!dense_ready_) {
      stepper_.stepper().prepare_dense_output();
      dense_ready_ = true;
    }
    stepper_.stepper().calc_state(phase, out, step.start, step.start_phase, step.end, step.end_phase);
  }

  void restart() {}

 private:
  template <class Dynamics>
  static auto implicit_system(Dynamics& dynamics) {
    return std::make_pair(
        [&dynamics](const State& x, State& rate, double phase) { dynamics(x, rate, phase); },
        [&dynamics](const State& x, auto& jacobian, const double& phase, State& phase_rate) {
          dynamics.jacobian(x, jacobian, phase, phase_rate);
        });
  }

  odeint::rosenbrock4_controller<odeint::rosenbrock4<double, RodasCoefficients>> stepper_;
  bool dense_ready_ = false;
};

}  // namespace rubsweep::integrate::adaptive
