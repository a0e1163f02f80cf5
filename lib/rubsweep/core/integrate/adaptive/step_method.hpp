#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// State of a run, and its rate: coordinates, their rates, then further numbers of a law.
using State = std::vector<double>;

inline bool is_finite(const State& state) {
  return std::ranges::all_of(state, [](double value) { return std::isfinite(value); });
}

/// First event inside a step; it ends the step.
struct Crossing {
  /// mode: a guard of a contact mode; stop: a slip reaches zero; release: a contact stops sticking; knot: a
  /// penetration passes a point where the force is not smooth.
  enum class Event { mode, stop, release, knot };
  double phase = 0;
  std::size_t contact = 0;
  contact::Mode next = contact::Mode::open;
  Event event = Event::mode;
  contact::Slip slip = contact::Slip::forward;  ///< direction of slip after a release
};

/// One attempted or accepted step of any method from `start` to `end`, with states and rates at both ends.
struct Step {
  double start_phase = 0, end_phase = 0;
  State start, start_rate, end, end_rate;
  double latest_phase = 0;           ///< latest end, where the law or its turn ends
  bool knows_modes = false;          ///< true: the method has searched for changes of mode and releases
  std::optional<Crossing> ending{};  ///< with `knows_modes`: the change that ends the step, if one does

  /// Exchanges the states and rates of both ends.
  void turn_around() {
    start.swap(end);
    start_rate.swap(end_rate);
  }
};

/// Interface of a law for methods: each method is compiled only once, not once for every law.
class RightHandSide {
 public:
  virtual ~RightHandSide() = default;
  virtual void operator()(const State& state, State& rate, double phase) = 0;

  /// Jacobian d(rate)/d(state), row by row, and d(rate)/d(phase). Only implicit methods use it.
  virtual void jacobian(const State& state, double* by_state, double phase, State& by_phase) = 0;

  virtual double friction_ratio(const State& state) = 0;  ///< Friction ratio, as Dynamics::friction_ratio.
};

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

/// Method that makes the steps of a run. It is an interface because the adaptive solver is the reference for
/// the others: simplicity comes before speed.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// Attempts a step of `size` radians from the given start. If it returns true, the step was accepted, and
  /// its `end`, `end_rate` and `end_phase` are filled. In both cases `size` becomes the next size to try.
  virtual bool try_step(RightHandSide& law, Step& step, double& size) = 0;

  /// State inside the last accepted step, by dense output where available, otherwise by repeating the method
  /// from the start of the step.
  virtual void state_at(RightHandSide& law, const Step& step, double phase, State& out) = 0;

  /// Moves tangent vectors (after the state, a row for the damping of each contact of `remembering`) over the
  /// last step up to a phase, to this relative accuracy; false, without any change, if the method cannot.
  virtual bool move_tangents(const Step&, double /*end_phase*/,
                             const std::vector<std::size_t>& /*remembering*/, double /*accuracy*/,
                             Eigen::Map<Eigen::MatrixXd>& /*vectors*/) {
    return false;
  }

  /// Discards what the method remembers of earlier steps, because the right-hand side has changed at a change
  /// of contact mode or an impulse.
  virtual void restart() {}

  /// Number of accepted implicit steps, for a method that also has explicit ones; otherwise 0.
  virtual long implicit_steps() const { return 0; }
};

/// The method of the stepper in `options`, with their tolerance. Throws SolverError for a number that is not
/// a stepper.
std::unique_ptr<StepMethod> make_step_method(const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
