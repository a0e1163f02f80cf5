#pragma once

#include <memory>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// State of a run, and its rate: coordinates, then their rates, then what a law adds.
using State = std::vector<double>;

/// One attempted or accepted step of any method: from `start` to `end`, states and rates at both.
struct Step {
  double start_phase = 0, end_phase = 0;
  State start, start_rate, end, end_rate;
};

/// A law as methods see it, so that each method is compiled once and not once for every law.
class RightHandSide {
 public:
  virtual ~RightHandSide() = default;
  virtual void operator()(const State& state, State& rate, double phase) = 0;

  /// d(rate)/d(state), row by row, and d(rate)/d(phase). Implicit methods alone ask for it.
  virtual void jacobian(const State& state, double* by_state, double phase, State& by_phase) = 0;

  /// As Dynamics::friction_ratio.
  virtual double friction_ratio(const State& state) = 0;
};

/// How a run makes a step. An interface, as the adaptive solver is the reference for the others: it is to be
/// plain before it is fast.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// Attempts a step of `size` radians, its start being filled in. True: it was accepted, and the step's
  /// `end`, `end_rate` and `end_phase` are filled. Either way `size` becomes the next size to try.
  virtual bool try_step(RightHandSide& law, Step& step, double& size) = 0;

  /// A state inside the last accepted step: by dense output where the method has one, else by the same
  /// method again from the start of the step.
  virtual void state_at(RightHandSide& law, const Step& step, double phase, State& out) = 0;

  /// The right-hand side has changed its form, at a change of contact mode or an impulse: what the method
  /// remembers of earlier steps is of no use.
  virtual void restart() {}

  /// Accepted steps so far of a method that has others as well; 0 of all others.
  virtual long implicit_steps() const { return 0; }
};

/// The method of the stepper that `options` name, with their tolerance. Throws SolverError for a number that
/// is no stepper.
std::unique_ptr<StepMethod> make_step_method(const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
