#pragma once

#include "rubsweep/core/integrate/adaptive/step_method.hpp"

namespace rubsweep::integrate::adaptive {

/// Adapts a law, whose type is a template, to the interface used by the methods.
template <class Law>
class LawOfSteps final : public RightHandSide {
 public:
  /// `law` must outlive this object.
  explicit LawOfSteps(Law& law) : law_(law) {}

  void operator()(const State& state, State& rate, double phase) override { law_(state, rate, phase); }

  void jacobian(const State& state, double* by_state, double phase, State& by_phase) override {
    const std::size_t size = state.size();
    law_.jacobian(
        state, [&](std::size_t row, std::size_t column) -> double& { return by_state[row * size + column]; },
        phase, by_phase);
  }

  double friction_ratio(const State& state) override { return law_.friction_ratio(state); }

 private:
  Law& law_;
};

}  // namespace rubsweep::integrate::adaptive
