#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/adaptive/event_search.hpp"
#include "rubsweep/core/integrate/adaptive/step_tangents.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/taylor/slip_zeros.hpp"

namespace rubsweep::integrate::adaptive {

/// Changes of contact mode and of slip at the end of a step of an adaptive run. All arguments belong to the
/// run and must outlive this.
template <class Law>
class StepSwitches {
 public:
  StepSwitches(Law& law, Step& step, std::vector<contact::Kinematics>& end_kinematics, run::TurnBook& book,
               Tangents<Law>& tangents, State& scratch_rate)
      : dynamics_(law),
        step_(step),
        end_kinematics_(end_kinematics),
        book_(book),
        tangents_(tangents),
        rate_before_(scratch_rate),
        zeros_(law.system().contacts.size()) {}

  /// Slips that start from zero and grow.
  const taylor::SlipZeros& zeros() const { return zeros_; }

  /// Takes up slip or sticking of all contacts at the start of the step, at this phase.
  void enter_slips(double phase) {
    law::enter_slips_by_state(dynamics_, step_.start, step_.start_rate, phase);
    zeros_.enter(dynamics_, step_.start);
  }

  /// Makes the change at the event that ended the step, if there was an event, and the changes that follow
  /// from it. Returns whether there were any changes.
  bool make(const std::optional<Crossing>& crossing, run::TurnReport& report) {
    bool switched = false;
    zeros_.clear();
    if (crossing && crossing->event != Crossing::Event::mode && crossing->event != Crossing::Event::knot) {
      switch_slip(*crossing);
      switched = true;
    }
    for (std::size_t i = 0; i < end_kinematics_.size(); ++i) {
      contact::Mode& mode = dynamics_.modes()[i];
      const contact::Mode from = mode;
      if (crossing && crossing->contact == i && crossing->event == Crossing::Event::mode)
        mode = contact::mode_through(from, crossing->next, end_kinematics_[i]);
      mode = dynamics_.mode_after(i, mode, end_kinematics_[i]);
      if (mode == from) continue;
      switched = true;
      if (from == contact::Mode::open) begin_impact(i);
      book_.note_switch({step_.end_phase, static_cast<int>(i), from, mode, dynamics_.impact_damping(i)},
                        report);
      if (mode == contact::Mode::open && dynamics_.any_poised())
        law::settle_slips(dynamics_, step_.end, rate_before_, step_.end_phase,
                          [](std::size_t) { return false; });
      if (from == contact::Mode::open && dynamics_.touches_dry(i)) touch_down(i);
    }
    return switched;
  }

  /// Kinematics at the end of a step with the present rate.
  void look_at_end() {
    for (std::size_t j = 0; j < end_kinematics_.size(); ++j)
      end_kinematics_[j] = dynamics_.kinematics(j, step_.end, step_.end_rate);
  }

 private:
  void begin_impact(std::size_t i) {
    dynamics_.begin_impact(i, end_kinematics_[i].closing_speed);
    to_tangents(tangents_, [&](auto& vectors) { vectors.begin_impact(i, step_.end, step_.end_rate); });
  }

  /// When contact begins, its friction rises from zero.
  void touch_down(std::size_t i) {
    law::take_slip_of_state(dynamics_, i, step_.end);
    if (dynamics_.slips()[i] == contact::Slip::sticking) stop_slip(i);
  }

  void switch_slip(const Crossing& crossing) {
    ++book_.effort.switches;
    if (crossing.event == Crossing::Event::release) {
      const std::size_t i = crossing.contact;
      const bool jumps = dynamics_.jumps(i);
      to_tangents(tangents_, [&](auto& vectors) {
        if (jumps) vectors.see_release(i, crossing.slip, step_.end, step_.end_rate, step_.end_phase);
      });
      zeros_.let_go(dynamics_, i, crossing.slip, step_.end, rate_before_, step_.end_phase);
      if (!jumps) return;
      rate_before_ = step_.end_rate;
      dynamics_(step_.end, step_.end_rate, step_.end_phase);
      to_tangents(tangents_, [&](auto& vectors) { vectors.cross_release(rate_before_, step_.end_rate); });
      look_at_end();
    } else {
      stop_slip(crossing.contact);
    }
  }

  /// Decides stick or slip for contact `i` when its slip is zero; the rate jumps together with the friction.
  void stop_slip(std::size_t i) {
    rate_before_ = step_.end_rate;
    zeros_.stop(dynamics_, i, step_.end, step_.end_rate, step_.end_phase);
    dynamics_(step_.end, step_.end_rate, step_.end_phase);
    to_tangents(tangents_,
                [&](auto& vectors) { vectors.cross_stop(i, step_.end, rate_before_, step_.end_rate); });
    if constexpr (requires { dynamics_.changes(step_.end); }) {
      law::cross_slip(dynamics_, i, step_.end, rate_before_, step_.end_rate, dynamics_.changes(step_.end));
      dynamics_(step_.end, step_.end_rate, step_.end_phase);
    }
    look_at_end();
  }

  Law& dynamics_;
  Step& step_;
  std::vector<contact::Kinematics>& end_kinematics_;
  run::TurnBook& book_;
  Tangents<Law>& tangents_;
  State& rate_before_;  ///< rate of the state before a change
  taylor::SlipZeros zeros_;
};

}  // namespace rubsweep::integrate::adaptive
