#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"

#include <algorithm>
#include <array>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/adaptive/steppers.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

/// dopri5, except that rosenbrock4 makes each step that starts in stiff friction (`Dynamics::friction_ratio`
/// above `stiff_friction_ratio`). The choice depends only on the state at the start of the step, so that a
/// run may be resumed anywhere. Bit for bit equal to dopri5 where friction is never stiff.
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

using run::Stepper;

template <class Method>
std::unique_ptr<StepMethod> make(const run::SolverOptions& options) {
  return std::make_unique<Method>(options);
}

constexpr std::string_view dopri5 = "dopri5 (Dormand-Prince 5(4), dense output of order 4)";

/// Table of the steppers. It is a switch so that a stepper without a row does not compile.
constexpr StepperRow make_row(Stepper stepper) {
  switch (stepper) {
    case Stepper::automatic: return {stepper, to_string(stepper), dopri5, make<Dopri5OrRosenbrock4>};
    case Stepper::dopri5: return {stepper, to_string(stepper), dopri5, make<Dopri5>};
    case Stepper::cash_karp54:
      return {stepper, to_string(stepper), "cash_karp54 (order 5(4), states inside a step by re-stepping)",
              make<ReStepping<odeint::runge_kutta_cash_karp54<State>>>};
    case Stepper::rkf78:
      return {stepper, to_string(stepper), "rkf78 (order 8(7), states inside a step by re-stepping)",
              make<ReStepping<odeint::runge_kutta_fehlberg78<State>>>};
    case Stepper::bulirsch_stoer:
      return {stepper, to_string(stepper),
              "bulirsch_stoer (variable order, states inside a step by re-stepping)", make<BulirschStoer>};
    case Stepper::rosenbrock4:
      return {stepper, to_string(stepper), "rosenbrock4 (implicit, order 4(3), dense output)",
              make<Rosenbrock4>};
  }
  return {};
}

constexpr auto& steppers = enumerators_of<Stepper, [](Stepper stepper) { return make_row(stepper).word; }>;
static_assert(steppers.front() == Stepper::automatic, "single_steppers leaves the first one out");

constexpr auto rows = [] {
  std::array<StepperRow, steppers.size()> all;
  std::ranges::transform(steppers, all.begin(), make_row);
  return all;
}();

}  // namespace

std::span<const StepperRow> stepper_table() { return rows; }

const StepperRow& row_of(Stepper stepper) {
  const auto row = std::ranges::find(rows, stepper, &StepperRow::stepper);
  if (row == rows.end()) throw SolverError("stepper without a row in its table");
  return *row;
}

std::unique_ptr<StepMethod> make_step_method(const run::SolverOptions& options) {
  return row_of(options.stepper).make(options);
}

std::span<const Stepper> single_steppers() { return std::span(steppers).subspan(1); }

}  // namespace rubsweep::integrate::adaptive
