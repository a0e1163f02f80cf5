#pragma once

#include "rubsweep/integrate/adaptive/steppers.hpp"

namespace rubsweep::integrate::adaptive {

/// dopri5, except that a step that starts in stiff friction (`Dynamics::friction_ratio` above
/// `stiff_friction_ratio`) is one of rosenbrock4. The choice depends on the
/// state where the step starts, not on what came before, so that a run may be taken up anywhere. Bit for bit
/// dopri5 where friction is never stiff.
class Dopri5OrRosenbrock4 final : public StepMethod {
 public:
  explicit Dopri5OrRosenbrock4(const run::SolverOptions& options)
      : explicit_(options),
        implicit_(options),
        stiff_above_(run::stiff_friction_ratio(options.relative_tolerance)) {}

  bool try_step(RightHandSide& law, Step& step, double& size) override {
    last_was_implicit_ = law.friction_ratio(step.start) > stiff_above_;
    if (!last_was_implicit_) return explicit_.try_step(law, step, size);
    if (!implicit_.try_step(law, step, size)) return false;
    ++implicit_steps_;
    return true;
  }

  void state_at(RightHandSide& law, const Step& step, double phase, State& out) override {
    if (!last_was_implicit_) return explicit_.state_at(law, step, phase, out);
    implicit_.state_at(law, step, phase, out);
  }

  long implicit_steps() const override { return implicit_steps_; }

 private:
  Dopri5 explicit_;
  Rosenbrock4 implicit_;
  double stiff_above_;
  bool last_was_implicit_ = false;
  long implicit_steps_ = 0;
};

}  // namespace rubsweep::integrate::adaptive
