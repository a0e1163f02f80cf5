#pragma once

#include <algorithm>
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

#include "rubsweep/core/integrate/adaptive/step_method.hpp"

namespace rubsweep::integrate::adaptive {

namespace odeint = boost::numeric::odeint;

inline odeint::default_error_checker<double, odeint::algebra_dispatcher<State>::algebra_type,
                                     odeint::operations_dispatcher<State>::operations_type>
error_checker(double tolerance) {
  // |error| <= tolerance (1 + |x|): absolute in units of (clearance, clearance * speed), plus relative.
  return {tolerance, tolerance, 1.0, 0.0};
}

/// Dormand-Prince 5(4) with its dense output of order 4. (Hairer, Norsett, Wanner, Solving ODEs I, II.5-6.)
class Dopri5 final : public StepMethod {
 public:
  explicit Dopri5(const run::SolverOptions& options) : stepper_(error_checker(options.relative_tolerance)) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    double phase = step.start_phase;
    const auto result =
        stepper_.try_step(std::ref(law), step.start, step.start_rate, phase, step.end, step.end_rate, size);
    step.end_phase = phase;
    return result == odeint::success;
  }

  void state_at(RightHandSide&, const Step& step, double phase, State& out) override {
    stepper_.stepper().calc_state(phase, out, step.start, step.start_rate, step.start_phase, step.end,
                                  step.end_rate, step.end_phase);
  }

 private:
  odeint::controlled_runge_kutta<odeint::runge_kutta_dopri5<State>> stepper_;
};

/// Embedded Runge-Kutta pairs without dense output: cash_karp54, rkf78.
template <class ErrorStepper>
class ReStepping final : public StepMethod {
 public:
  explicit ReStepping(const run::SolverOptions& options)
      : stepper_(error_checker(options.relative_tolerance)) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    double phase = step.start_phase;
    const auto result = stepper_.try_step(std::ref(law), step.start, step.start_rate, phase, step.end, size);
    if (result != odeint::success) return false;
    step.end_phase = phase;
    law(step.end, step.end_rate, phase);
    return true;
  }

  void state_at(RightHandSide& law, const Step& step, double phase, State& out) override {
    out = step.start;
    stepper_.stepper().do_step(std::ref(law), step.start, step.start_rate, step.start_phase, out,
                               phase - step.start_phase);
  }

 private:
  odeint::controlled_runge_kutta<ErrorStepper> stepper_;
};

/// Extrapolated midpoint rule of variable order. Odeint's dense variant cannot be stopped at a mode switch,
/// so that states inside a step are computed by repeating the method from the step's start.
class BulirschStoer final : public StepMethod {
 public:
  explicit BulirschStoer(const run::SolverOptions& options)
      : tolerance_(options.relative_tolerance), stepper_(tolerance_, tolerance_, 1.0, 0.0) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    double phase = step.start_phase;
    step.end = step.start;
    const auto result = stepper_.try_step(std::ref(law), step.start, step.start_rate, phase, step.end, size);
    if (result != odeint::success) return false;
    step.end_phase = phase;
    law(step.end, step.end_rate, phase);
    return true;
  }

  void state_at(RightHandSide& law, const Step& step, double target, State& out) override {
    odeint::bulirsch_stoer<State> stepper(tolerance_, tolerance_, 1.0, 0.0);
    out = step.start;
    State from = step.start, rate = step.start_rate;
    double phase = step.start_phase, size = target - phase;
    // The whole step passed the error control. A part of it therefore passes at once or after a few halvings.
    for (int attempt = 0; attempt < 1000 && phase < target; ++attempt) {
      if (phase + size > target) size = target - phase;
      const bool last = phase + size == target;
      if (stepper.try_step(std::ref(law), from, rate, phase, out, size) != odeint::success) continue;
      if (last) return;
      from = out;
      law(from, rate, phase);
    }
    // A state before `target` is not the result: NaN ends the run if `target` was not reached.
    if (phase < target) std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  }

  void restart() override { stepper_.reset(); }

 private:
  double tolerance_;
  odeint::bulirsch_stoer<State> stepper_;
};

/// Odeint's RODAS coefficients with the correct sign of d4. Boost 1.81 has +0.0362, which reduces the method
/// to first order when the right-hand side depends on time (Hairer & Wanner, RODAS: D4 = -0.0362).
struct RodasCoefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;
};

/// Rosenbrock method of order 4 with dense output, for stiff friction. Uses the analytic Jacobian of the
/// law.
class Rosenbrock4 final : public StepMethod {
  using Vector = boost::numeric::ublas::vector<double>;

  auto system_of(RightHandSide& law) {
    return std::make_pair(
        [&, this](const Vector& x, Vector& rate, double phase) {
          std::copy(x.begin(), x.end(), state_.begin());
          law(state_, rate_, phase);
          std::copy(rate_.begin(), rate_.end(), rate.begin());
        },
        [&, this](const Vector& x, auto& jacobian, const double& phase, Vector& phase_rate) {
          std::copy(x.begin(), x.end(), state_.begin());
          law.jacobian(state_, &jacobian(0, 0), phase, rate_);
          std::copy(rate_.begin(), rate_.end(), phase_rate.begin());
        });
  }

 public:
  explicit Rosenbrock4(const run::SolverOptions& options)
      : stepper_(options.relative_tolerance, options.relative_tolerance) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    for (Vector* vector : {&start_, &end_, &inside_}) vector->resize(step.start.size(), false);
    for (State* room : {&state_, &rate_}) room->resize(step.start.size());
    std::copy(step.start.begin(), step.start.end(), start_.begin());
    double phase = step.start_phase;
    if (stepper_.try_step(system_of(law), start_, phase, end_, size) != odeint::success) return false;
    step.end_phase = phase;
    std::copy(end_.begin(), end_.end(), step.end.begin());
    law(step.end, step.end_rate, phase);
    dense_ready_ = false;
    return true;
  }

  void state_at(RightHandSide&, const Step& step, double phase, State& out) override {
    if (!dense_ready_) {
      stepper_.stepper().prepare_dense_output();
      dense_ready_ = true;
    }
    stepper_.stepper().calc_state(phase, inside_, start_, step.start_phase, end_, step.end_phase);
    std::copy(inside_.begin(), inside_.end(), out.begin());
  }

 private:
  odeint::rosenbrock4_controller<odeint::rosenbrock4<double, RodasCoefficients>> stepper_;
  Vector start_, end_, inside_;  ///< states of the last step
  State state_, rate_;           ///< scratch
  bool dense_ready_ = false;
};

}  // namespace rubsweep::integrate::adaptive
