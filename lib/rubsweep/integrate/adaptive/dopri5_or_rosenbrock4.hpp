#pragma once

#include <algorithm>
#include <limits>

#include "rubsweep/integrate/adaptive/steppers.hpp"

namespace rubsweep::integrate::adaptive {

/// dopri5, except that with `Stepper::automatic` a step that starts in stiff friction
/// (`Dynamics::friction_ratio` above `stiff_friction_ratio`) is one of rosenbrock4. The choice depends on the
/// state where the step starts, not on what came before, so that a run may be taken up anywhere. Bit for bit
/// dopri5 where friction is never stiff.
template <class StateType>
class Dopri5OrRosenbrock4 {
 public:
  using State = StateType;
  explicit Dopri5OrRosenbrock4(const run::SolverOptions& options)
      : explicit_(options),
        implicit_(options),
        stiff_above_(options.stepper == run::Stepper::automatic
                         ? run::stiff_friction_ratio(options.relative_tolerance)
                         : std::numeric_limits<double>::infinity()) {}

  template <class Dynamics>
  bool try_step(Dynamics& dynamics, Step<State>& step, double& size) {
    last_was_implicit_ = stiff_above_ < std::numeric_limits<double>::infinity() &&
                         dynamics.friction_ratio(step.start) > stiff_above_;
    return last_was_implicit_ ? try_implicit(dynamics, step, size) : explicit_.try_step(dynamics, step, size);
  }

  template <class Dynamics>
  void state_at(Dynamics& dynamics, const Step<State>& step, double phase, State& out) {
    if (!last_was_implicit_) return explicit_.state_at(dynamics, step, phase, out);
    implicit_.state_at(dynamics, inner_, phase, inner_probe_);
    std::copy(inner_probe_.begin(), inner_probe_.end(), out.begin());
  }

  void restart() {}

  long implicit_steps() const { return implicit_steps_; }

 private:
  template <class Dynamics>
  bool try_implicit(Dynamics& dynamics, Step<State>& step, double& size) {
    if (inner_.start.size() == 0) {
      for (auto* state : {&inner_.start, &inner_.end, &inner_.end_rate, &inner_probe_})
        state->resize(step.start.size());
    }
    inner_.start_phase = step.start_phase;
    std::copy(step.start.begin(), step.start.end(), inner_.start.begin());
    if (!implicit_.try_step(dynamics, inner_, size)) return false;
    ++implicit_steps_;
    step.end_phase = inner_.end_phase;
    std::copy(inner_.end.begin(), inner_.end.end(), step.end.begin());
    std::copy(inner_.end_rate.begin(), inner_.end_rate.end(), step.end_rate.begin());
    return true;
  }

  Dopri5<State> explicit_;
  Rosenbrock4 implicit_;
  Step<Rosenbrock4::State> inner_;
  Rosenbrock4::State inner_probe_;
  double stiff_above_;
  bool last_was_implicit_ = false;
  long implicit_steps_ = 0;
};

}  // namespace rubsweep::integrate::adaptive
