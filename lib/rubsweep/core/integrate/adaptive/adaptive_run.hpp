#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "rubsweep/core/integrate/adaptive/event_search.hpp"
#include "rubsweep/core/integrate/adaptive/law_of_steps.hpp"
#include "rubsweep/core/integrate/adaptive/step_observer.hpp"
#include "rubsweep/core/integrate/adaptive/step_tangents.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/run/turn_clock.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::adaptive {

/// A run with one of Odeint's steppers. Located (law not smoothed): a step that crosses a mode's guard is cut
/// there, and the next one starts in the new mode. Inside a step the right-hand side is smooth, so that the
/// stepper keeps its order. A step also ends where a slip with dry friction reaches zero or a contact stops
/// sticking. `Law` is the right-hand side: Dynamics, or a law with further numbers after its state.
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
        end_kinematics_(system_.contacts.size()),
        just_moved_(system_.contacts.size(), false) {
    const std::vector<double> initial = dynamics_.whole_state(run::scaled_initial_state(scene));
    for (State* state : {&step_.start, &step_.start_rate, &step_.end, &step_.end_rate, &probe_, &probe_rate_})
      state->resize(initial.size());
    std::copy(initial.begin(), initial.end(), step_.start.begin());
    remembered_sizes_.resize(std::size_t{1} << (2 * std::min<std::size_t>(system_.contacts.size(), 4)), 0.0);
    size_ = 1e-3;
    begin();
  }

  // Not copyable: the dynamics refer to the system.
  AdaptiveRun(const AdaptiveRun&) = delete;
  AdaptiveRun& operator=(const AdaptiveRun&) = delete;

  /// Integrates phases 0 to `end_phase` of the next revolution; the run is over when that is less than 2 pi.
  /// Moves tangent vectors beside contacts whose law is not linear alone.
  run::Outcome advance(const run::TurnRequest& request, run::TurnReport& report,
                       double end_phase = numerics::full_turn) {
    StepObserver observer(request, report);
    book_.begin_turn(request);
    book_.limit_steps(max_steps_);
    const long evaluations = dynamics_.rhs_calls() + max_evaluations_;
    step_.start_phase = 0;
    // Pulses come first, because they count their time from the start of the turn.
    clock_.begin_turn(book_.revolution, end_phase);
    dynamics_(step_.start, step_.start_rate, 0.0);
    if constexpr (has_step_tangents<Law>) tangents_.begin(request, tolerance_, step_.start);
    while (!clock_.turn_is_over()) {
      if (!book_.may_step() || dynamics_.rhs_calls() >= evaluations)
        return finish(report, run::Outcome::step_limit);
      if (dynamics_.unsettled()) return finish(report, run::Outcome::friction_unsettled);
      if (clock_.impulse_is_due()) apply_impulses(observer);
      const run::Outcome outcome = advance_one_step(observer);
      if (outcome != run::Outcome::ok) return finish(report, outcome);
    }
    report.section.assign(step_.start.begin(), step_.start.end());
    book_.end_turn(StepObserver::touching(step_.start, dynamics_), report);
    if constexpr (has_step_tangents<Law>) tangents_.finish(report);
    return finish(report, run::Outcome::ok);
  }

 private:
  static constexpr double smallest_size = 1e-14;

  void begin() {
    dynamics_.follow(clock_.pulses());
    clock_.begin_turn(0);
    dynamics_(step_.start, step_.start_rate, 0.0);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      dynamics_.enter_by_state(i, step_.start, step_.start_rate);
    enter_slips(0);
    if constexpr (requires { dynamics_.changes(step_.start); })
      dynamics_.keep_sticking(step_.start, dynamics_.changes(step_.start));
    look_again(0);
  }

  void enter_slips(double phase) {
    law::enter_slips_by_state(dynamics_, step_.start, step_.start_rate, phase);
    for (std::size_t i = 0; i < just_moved_.size(); ++i)
      just_moved_[i] = leaves_zero(i) && law::stands(dynamics_, i, step_.start);
  }

  /// Whether the slip of contact `i`, if it is zero, begins to grow.
  bool leaves_zero(std::size_t i) const {
    return dynamics_.touches_dry(i) && dynamics_.slips()[i] != contact::Slip::sticking &&
           !dynamics_.poised(i);
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
    enter_slips(step_.start_phase);
    to_tangents([this](auto& vectors) { vectors.keep_sticking(step_.start); });
    look_again(step_.start_phase);
    method_->restart();
  }

  run::Outcome advance_one_step(StepObserver& observer) {
    clock_.change_pulses();
    const double boundary = clock_.next_boundary();
    const double wanted = size_;
    // The step is extended when the rest to the boundary would be too small for a step.
    const bool limited = step_.start_phase + 1.000001 * wanted >= boundary;
    double size = limited ? boundary - step_.start_phase : wanted;
    const double taken = size;
    if (!method_->try_step(right_hand_side_, step_, size)) {
      book_.refuse_step();
      size_ = size;
      return size_ < smallest_size ? run::Outcome::step_too_small : run::Outcome::ok;
    }
    if (!finite(step_.end)) {
      book_.refuse_step();
      size_ = taken / 10;
      return size_ < smallest_size ? run::Outcome::non_finite : run::Outcome::ok;
    }
    ++book_.effort.steps;
    size_ = limited ? std::max(size, wanted) : size;
    if (limited) step_.end_phase = boundary;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      end_kinematics_[i] = dynamics_.kinematics(i, step_.end, step_.end_rate);
    }
    accept(observer);
    return run::Outcome::ok;
  }

  /// Cuts the accepted step at its first mode switch, reports it, and makes its end the next start.
  void accept(StepObserver& observer) {
    std::optional<Crossing> crossing;
    if constexpr (!smoothed) crossing = first_crossing();
    const auto state_at = [this](double phase) -> const State& {
      method_->state_at(right_hand_side_, step_, phase, probe_);
      return probe_;
    };
    const double end_phase = crossing ? crossing->phase : step_.end_phase;
    observer.sample(step_.start_phase, step_.start, end_phase, state_at);
    to_tangents([&](auto& vectors) { vectors.follow(*method_, right_hand_side_, step_, end_phase); });
    if (crossing) cut_step(end_phase);
    observer.watch(step_, dynamics_, start_kinematics_, end_kinematics_);
    if constexpr (!smoothed) switch_modes(crossing, observer);
    std::swap(step_.start, step_.end);
    std::swap(step_.start_rate, step_.end_rate);
    std::swap(start_kinematics_, end_kinematics_);
    step_.start_phase = end_phase;
    clock_.go_to(end_phase);
  }

  std::optional<Crossing> first_crossing() {
    return CrossingSearch<Law>{dynamics_,       right_hand_side_, *method_, step_,      start_kinematics_,
                               end_kinematics_, just_moved_,      probe_,   probe_rate_}
        .first();
  }

  void cut_step(double phase) {
    method_->state_at(right_hand_side_, step_, phase, probe_);
    step_.end = probe_;
    step_.end_phase = phase;
    // The force is continuous at a mode switch, so that this rate holds on both sides of it.
    dynamics_(step_.end, step_.end_rate, phase);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      end_kinematics_[i] = dynamics_.kinematics(i, step_.end, step_.end_rate);
    }
  }

  void switch_modes(const std::optional<Crossing>& crossing, StepObserver& observer) {
    bool switched = false;
    const std::size_t before = joint_mode();
    std::fill(just_moved_.begin(), just_moved_.end(), false);
    if (crossing && crossing->event != Crossing::Event::mode) {
      switch_slip(*crossing);
      switched = true;
    }
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
      contact::Mode& mode = dynamics_.modes()[i];
      const contact::Mode from = mode;
      if (crossing && crossing->contact == i && crossing->event == Crossing::Event::mode)
        mode = contact::mode_through(from, crossing->next, end_kinematics_[i]);
      mode = dynamics_.mode_after(i, mode, end_kinematics_[i]);
      if (mode == from) continue;
      switched = true;
      if (from == contact::Mode::open) begin_impact(i);
      book_.note_switch({step_.end_phase, static_cast<int>(i), from, mode, dynamics_.impact_damping(i)},
                        observer.report());
      if (mode == contact::Mode::open && dynamics_.any_poised())
        law::settle_slips(dynamics_, step_.end, probe_rate_, step_.end_phase,
                          [](std::size_t) { return false; });
      if (from == contact::Mode::open && dynamics_.touches_dry(i)) touch_down(i);
    }
    if (!switched) return;
    method_->restart();
    // Contact and flight need different step sizes: continues with the latest size used in this mode.
    remembered_sizes_[before] = size_;
    if (const double remembered = remembered_sizes_[joint_mode()]; remembered > 0) size_ = remembered;
  }

  void begin_impact(std::size_t i) {
    dynamics_.begin_impact(i, end_kinematics_[i].closing_speed);
    to_tangents([&](auto& vectors) { vectors.begin_impact(i, step_.end, step_.end_rate); });
  }

  /// The friction of a contact that begins rises from zero.
  void touch_down(std::size_t i) {
    law::take_slip_of_state(dynamics_, i, step_.end);
    if (dynamics_.slips()[i] == contact::Slip::sticking) stop_slip(i);
  }

  void switch_slip(const Crossing& crossing) {
    ++book_.effort.switches;
    if (crossing.event == Crossing::Event::release) {
      const std::size_t i = crossing.contact;
      const bool jumps = dynamics_.jumps(i);
      to_tangents([&](auto& vectors) {
        if (jumps) vectors.see_release(i, crossing.slip, step_.end, step_.end_rate, step_.end_phase);
      });
      const bool others = law::let_go(dynamics_, i, crossing.slip, step_.end, probe_rate_, step_.end_phase);
      for (std::size_t j = 0; j < system_.contacts.size(); ++j) {
        if (j == i || (others && law::stands(dynamics_, j, step_.end))) just_moved_[j] = leaves_zero(j);
      }
      if (!jumps) return;
      probe_rate_ = step_.end_rate;
      dynamics_(step_.end, step_.end_rate, step_.end_phase);
      to_tangents([&](auto& vectors) { vectors.cross_release(probe_rate_, step_.end_rate); });
      look_at_end();
    } else {
      stop_slip(crossing.contact);
    }
  }

  /// Settles contact `i` when its slip is zero; the rate jumps together with its friction.
  void stop_slip(std::size_t i) {
    probe_rate_ = step_.end_rate;
    law::settle_slips(dynamics_, step_.end, step_.end_rate, step_.end_phase,
                      [&](std::size_t j) { return j == i; });
    for (std::size_t j = 0; j < system_.contacts.size(); ++j) {
      if (dynamics_.touches_dry(j) && (j == i || law::stands(dynamics_, j, step_.end)))
        just_moved_[j] = leaves_zero(j);
    }
    dynamics_(step_.end, step_.end_rate, step_.end_phase);
    to_tangents([&](auto& vectors) { vectors.cross_stop(i, step_.end, probe_rate_, step_.end_rate); });
    if constexpr (requires { dynamics_.changes(step_.end); }) {
      law::cross_slip(dynamics_, i, step_.end, probe_rate_, step_.end_rate, dynamics_.changes(step_.end));
      dynamics_(step_.end, step_.end_rate, step_.end_phase);
    }
    look_at_end();
  }

  /// Kinematics at the end of a step with the present rate.
  void look_at_end() {
    for (std::size_t j = 0; j < system_.contacts.size(); ++j)
      end_kinematics_[j] = dynamics_.kinematics(j, step_.end, step_.end_rate);
  }

  std::size_t joint_mode() const {
    std::size_t joint = 0;
    const auto& modes = dynamics_.modes();
    for (std::size_t i = 0; i < std::min<std::size_t>(modes.size(), 4); ++i) {
      joint = joint * contact::mode_count + static_cast<std::size_t>(modes[i]);
    }
    return joint;
  }

  static bool finite(const State& state) {
    return std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); });
  }

  run::Outcome finish(run::TurnReport& report, run::Outcome outcome) const {
    report.effort = book_.effort;
    report.effort.rhs_calls = dynamics_.rhs_calls();
    if constexpr (has_step_tangents<Law>) report.effort.rhs_calls += tangents_.work();
    report.effort.implicit_steps = method_->implicit_steps();
    return outcome;
  }

  struct NoTangents {
    explicit NoTangents(const Law&) {}
  };

  /// Has the tangent vectors of this turn, where there are any, taken across something.
  template <class Act>
  void to_tangents(const Act& act) {
    if constexpr (has_step_tangents<Law>) {
      if (tangents_.any()) act(tangents_);
    }
  }

  run::ScaledSystem<Law::coordinates> system_;
  Law dynamics_;
  std::conditional_t<has_step_tangents<Law>, StepTangents<Law>, NoTangents> tangents_{dynamics_};
  LawOfSteps<Law> right_hand_side_{dynamics_};
  std::unique_ptr<StepMethod> method_;
  run::TurnClock clock_;  ///< clock in radians
  run::TurnBook book_;
  long max_steps_, max_evaluations_;  ///< of a turn
  double tolerance_;
  Step step_;
  State probe_, probe_rate_;
  double size_ = 0;                       ///< next step to try, in radians of rotation
  std::vector<double> remembered_sizes_;  ///< for each joint mode of the first four contacts; 0: none yet
  std::vector<contact::Kinematics> start_kinematics_, end_kinematics_;
  /// Whether the slip of each contact starts from zero and grows.
  std::vector<bool> just_moved_;
};

extern template class AdaptiveRun<law::Dynamics<4, false>>;
extern template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, false>>;
extern template class AdaptiveRun<law::Dynamics<Eigen::Dynamic, true>>;

}  // namespace rubsweep::integrate::adaptive
