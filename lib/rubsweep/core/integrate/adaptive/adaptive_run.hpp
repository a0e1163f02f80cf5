#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/adaptive/event_search.hpp"
#include "rubsweep/core/integrate/adaptive/step_observer.hpp"
#include "rubsweep/core/integrate/adaptive/step_sizes.hpp"
#include "rubsweep/core/integrate/adaptive/step_switches.hpp"
#include "rubsweep/core/integrate/adaptive/step_tangents.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/run/turn_clock.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::adaptive {

/// A run with one of Odeint's steppers. With a located law (not smoothed), a step that crosses a mode's guard
/// is cut there, and the next step starts in the new mode. Inside a step the right-hand side is smooth, so
/// that the stepper keeps its order. A step also ends where a slip with dry friction reaches zero or a
/// contact stops sticking. `Law` is the right-hand side: Dynamics, or a law with further numbers after its
/// state.
template <class Law>
class AdaptiveRun {
  static constexpr bool smoothed = Law::smoothed;

 public:
  /// `of_the_law`: further arguments of the law, after the system and the smoothing width.
  template <class... OfTheLaw>
  AdaptiveRun(const scene::Scene& scene, const run::SolverOptions& options, const OfTheLaw&... of_the_law)
      : system_(run::scale<Law::coordinates>(scene)),
        dynamics_(system_, options.smoothing_m / system_.scale.length_m, of_the_law...),
        method_(make_step_method(options)),
        clock_(run::TurnClock::in_radians(scene, system_.scale)),
        max_steps_(options.max_steps_per_revolution),
        max_evaluations_(run::most_evaluations_of_a_turn(options)),
        tolerance_(options.relative_tolerance),
        start_kinematics_(system_.contacts.size()),
        end_kinematics_(system_.contacts.size()) {
    const std::vector<double> initial = dynamics_.whole_state(run::scaled_initial_state(scene));
    for (State* state : {&step_.start, &step_.start_rate, &step_.end, &step_.end_rate, &probe_, &probe_rate_})
      state->resize(initial.size());
    std::copy(initial.begin(), initial.end(), step_.start.begin());
    begin();
  }

  // Not copyable: the dynamics refer to the system.
  AdaptiveRun(const AdaptiveRun&) = delete;
  AdaptiveRun& operator=(const AdaptiveRun&) = delete;

  /// Integrates phases 0 to `end_phase` of the next revolution; the run is over when `end_phase` is less than
  /// 2 pi. Tangent vectors are moved only if there are contacts whose law is not linear.
  run::Outcome advance(const run::TurnRequest& request, run::TurnReport& report,
                       double end_phase = numerics::full_turn) {
    report.clear();
    begin_turn(request, end_phase);
    const run::Outcome outcome = go_on(request, report, false);
    return outcome == run::Outcome::ok ? finish_turn(report) : outcome;
  }

  /// Makes steps by another method than that of the options.
  void step_by(std::unique_ptr<StepMethod> method) { method_ = std::move(method); }
  const Law& law() const { return dynamics_; }

  /// Begins a revolution that `go_on` and `finish_turn` complete.
  void begin_turn(const run::TurnRequest& request, double end_phase = numerics::full_turn) {
    begin_at(request, book_.revolution, 0, end_phase);
    dynamics_(step_.start, step_.start_rate, 0.0);
    if constexpr (has_step_tangents<Law>) tangents_.begin(request, tolerance_, step_.start);
  }

  /// Goes to the start of a revolution with this section, without memory of earlier turns.
  void restart(std::span<const double> section, long revolution) {
    std::ranges::copy(section, step_.start.begin());
    book_.revolution = revolution;
    step_.start_phase = 0;
    sizes_.forget();
    to_tangents(tangents_, [](auto& vectors) { vectors.forget(); });
    method_->restart();
    std::ranges::fill(dynamics_.modes(), contact::Mode::open);
    begin();
  }

  /// Continues a turn of a solver of flights at this phase, where contact `touches`, if any, begins to touch.
  /// Continues `report`, too.
  void join(const run::TurnRequest& request, long revolution, double phase, std::span<const double> state,
            std::optional<std::size_t> touches, run::TurnReport& report) {
    begin_at(request, revolution, phase, numerics::full_turn);
    clock_.change_pulses();
    std::ranges::copy(state, step_.start.begin());
    std::ranges::fill(dynamics_.modes(), contact::Mode::open);
    dynamics_.leave_unsettled(false);
    sizes_.restart();
    if constexpr (has_step_tangents<Law>) tangents_.begin(request, tolerance_, step_.start);
    look_again(phase);
    if (!touches) return;
    const contact::Mode next = dynamics_.guards(*touches, start_kinematics_[*touches]).list[0].next;
    StepObserver observer(request, report);
    turn_around();
    step_.end_phase = phase;
    switch_modes(Crossing{.phase = phase, .contact = *touches, .next = next}, observer);
    turn_around();
  }

  /// Makes steps until the end of the turn; or, with `to_flight`, until the last contact opens.
  run::Outcome go_on(const run::TurnRequest& request, run::TurnReport& report, bool to_flight) {
    StepObserver observer(request, report);
    const long evaluations = dynamics_.rhs_calls() + max_evaluations_;
    opened_ = false;
    while (!clock_.turn_is_over() && !(to_flight && opened_)) {
      if (!book_.may_step() || dynamics_.rhs_calls() >= evaluations)
        return finish(report, run::Outcome::step_limit);
      if (dynamics_.unsettled()) return finish(report, run::Outcome::friction_unsettled);
      if (clock_.impulse_is_due()) apply_impulses(observer);
      const run::Outcome outcome = advance_one_step(observer);
      if (outcome != run::Outcome::ok) return finish(report, outcome);
    }
    return finish(report, run::Outcome::ok);
  }

  /// Completes the report of a turn whose end `go_on` has reached.
  run::Outcome finish_turn(run::TurnReport& report) {
    report.section.assign(step_.start.begin(), step_.start.end());
    book_.end_turn(touches(), report);
    if constexpr (has_step_tangents<Law>) tangents_.finish(report);
    return finish(report, run::Outcome::ok);
  }

  run::Effort effort() const {
    run::Effort effort = book_.effort;
    effort.rhs_calls = dynamics_.rhs_calls();
    if constexpr (has_step_tangents<Law>) effort.rhs_calls += tangents_.work();
    effort.implicit_steps = method_->implicit_steps();
    return effort;
  }
  bool at_end_of_turn() const { return clock_.turn_is_over(); }
  double phase() const { return step_.start_phase; }
  /// Present state as in TurnReport::section, modes, and tangent vectors if there are any.
  const State& state() const { return step_.start; }
  const std::vector<contact::Mode>& modes() const { return dynamics_.modes(); }
  bool touches() const { return StepObserver::touching(step_.start, dynamics_); }
  void put_tangents(Eigen::MatrixXd& vectors) {
    bool any = false;
    to_tangents(tangents_, [&](auto& moved) { any = true, vectors = moved.changes(); });
    if (!any) vectors.resize(static_cast<Eigen::Index>(step_.start.size()), 0);
  }

 private:
  static constexpr double smallest_size = 1e-14;

  void begin_at(const run::TurnRequest& request, long revolution, double phase, double end_phase) {
    book_.revolution = revolution;
    book_.begin_turn(request);
    book_.limit_steps(max_steps_);
    step_.start_phase = phase;
    // Pulses count their time from the start of the turn.
    clock_.begin_turn(revolution, end_phase);
    clock_.go_to(phase);
  }

  void begin() {
    dynamics_.follow(clock_.pulses());
    clock_.begin_turn(book_.revolution);
    dynamics_(step_.start, step_.start_rate, 0.0);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      dynamics_.enter_by_state(i, step_.start, step_.start_rate);
    switches_.enter_slips(0);
    if constexpr (requires { dynamics_.changes(step_.start); })
      dynamics_.keep_sticking(step_.start, dynamics_.changes(step_.start));
    look_again(0);
  }

  /// Rate and kinematics at the start of a step with the present modes.
  void look_again(double phase) {
    dynamics_(step_.start, step_.start_rate, phase);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      start_kinematics_[i] = dynamics_.kinematics(i, step_.start, step_.start_rate);
  }

  /// Applies all impulses of this instant.
  void apply_impulses(StepObserver& observer) {
    while (clock_.impulse_is_due()) run::add_impulse(clock_.take_impulse(), system_.scale, step_.start);
    dynamics_(step_.start, step_.start_rate, step_.start_phase);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      const contact::Mode from = dynamics_.modes()[i];
      dynamics_.enter_by_state(i, step_.start, step_.start_rate);
      if (smoothed || dynamics_.modes()[i] == from) continue;
      book_.note_switch(
          {step_.start_phase, static_cast<int>(i), from, dynamics_.modes()[i], dynamics_.impact_damping(i)},
          observer.report());
    }
    switches_.enter_slips(step_.start_phase);
    to_tangents(tangents_, [this](auto& vectors) { vectors.keep_sticking(step_.start); });
    look_again(step_.start_phase);
    method_->restart();
  }

  run::Outcome advance_one_step(StepObserver& observer) {
    clock_.change_pulses();
    const double boundary = clock_.next_boundary();
    const double wanted = sizes_.next;
    // The step is extended when the rest to the boundary would be too small for a step.
    const bool limited = step_.start_phase + 1.000001 * wanted >= boundary;
    double size = limited ? boundary - step_.start_phase : wanted;
    const double taken = size;
    step_.latest_phase = boundary;
    if (!method_->try_step(right_hand_side_, step_, size)) {
      book_.refuse_step();
      sizes_.next = size;
      return sizes_.next < smallest_size ? run::Outcome::step_too_small : run::Outcome::ok;
    }
    if (!is_finite(step_.end)) {
      book_.refuse_step();
      sizes_.next = taken / 10;
      return sizes_.next < smallest_size ? run::Outcome::non_finite : run::Outcome::ok;
    }
    ++book_.effort.steps;
    if (!step_.knows_modes) {
      sizes_.next = limited ? std::max(size, wanted) : size;
      if (limited) step_.end_phase = boundary;
    }
    switches_.look_at_end();
    accept(observer);
    return run::Outcome::ok;
  }

  /// Cuts the accepted step at its first mode switch, reports it, and makes its end the next start.
  void accept(StepObserver& observer) {
    std::optional<Crossing> crossing;
    if constexpr (!smoothed) crossing = first_crossing();
    if (!step_.knows_modes && sizes_.retakes(crossing, step_.start_phase)) return;
    const auto state_at = [this](double phase) -> const State& {
      method_->state_at(right_hand_side_, step_, phase, probe_);
      return probe_;
    };
    const double end_phase = crossing ? crossing->phase : step_.end_phase;
    observer.sample(step_.start_phase, step_.start, end_phase, state_at);
    to_tangents(tangents_,
                [&](auto& vectors) { vectors.follow(*method_, right_hand_side_, step_, end_phase); });
    if (crossing && !(step_.knows_modes && end_phase == step_.end_phase)) cut_step(end_phase);
    parts_.watch(step_, start_kinematics_, end_kinematics_, dynamics_, right_hand_side_, *method_, observer);
    if constexpr (!smoothed) switch_modes(crossing, observer);
    turn_around();
    step_.start_phase = end_phase;
    clock_.go_to(end_phase);
  }

  /// Exchanges start and end of the step.
  void turn_around() {
    step_.turn_around();
    start_kinematics_.swap(end_kinematics_);
  }

  std::optional<Crossing> first_crossing() {
    return CrossingSearch<Law>{
        dynamics_,       right_hand_side_,          *method_, step_,      start_kinematics_,
        end_kinematics_, switches_.zeros().terms(), probe_,   probe_rate_}
        .first();
  }

  void cut_step(double phase) {
    method_->state_at(right_hand_side_, step_, phase, probe_);
    step_.end = probe_;
    step_.end_phase = phase;
    // The force is continuous at a mode switch, so that this rate holds on both sides of it.
    dynamics_(step_.end, step_.end_rate, phase);
    switches_.look_at_end();
  }

  void switch_modes(const std::optional<Crossing>& crossing, StepObserver& observer) {
    const std::size_t before = sizes_.joint_mode();
    const bool begins = crossing && crossing->event == Crossing::Event::mode &&
                        dynamics_.modes()[crossing->contact] == contact::Mode::open;
    if (!switches_.make(crossing, observer.report())) return;
    method_->restart();
    opened_ = std::ranges::all_of(dynamics_.modes(), [](auto mode) { return mode == contact::Mode::open; });
    sizes_.change(before);
    if (begins) sizes_.begin_contact(crossing->contact, end_kinematics_[crossing->contact].closing_speed);
  }

  run::Outcome finish(run::TurnReport& report, run::Outcome outcome) const {
    report.effort = effort();
    return outcome;
  }

  run::ScaledSystem<Law::coordinates> system_;
  Law dynamics_;
  Tangents<Law> tangents_{dynamics_};
  LawOfSteps<Law> right_hand_side_{dynamics_};
  std::unique_ptr<StepMethod> method_;
  run::TurnClock clock_;  ///< clock in radians
  run::TurnBook book_;
  long max_steps_, max_evaluations_;  ///< limits for a turn
  double tolerance_;
  Step step_;
  State probe_, probe_rate_;
  bool opened_ = false;  ///< true: the last change of mode was the opening of all
  StepSizes<Law> sizes_{dynamics_, tolerance_};
  std::vector<contact::Kinematics> start_kinematics_, end_kinematics_;
  StepParts parts_;
  StepSwitches<Law> switches_{dynamics_, step_, end_kinematics_, book_, tangents_, probe_rate_};
};

extern template class AdaptiveRun<law::Dynamics<4, false>>;
extern template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, false>>;
extern template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, true>>;

}  // namespace rubsweep::integrate::adaptive
