#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/adaptive/step_observer.hpp"

namespace rubsweep::integrate::adaptive {

/// Reports long steps, whose method `knows_modes`, in parts where peaks are wanted: the cubics with which an
/// observer finds peaks need short steps.
class StepParts {
 public:
  /// Reports `step` of `method`. `at_start`, `at_end`: kinematics of the contacts there.
  template <class Law>
  void watch(const Step& step, const std::vector<contact::Kinematics>& at_start,
             const std::vector<contact::Kinematics>& at_end, Law& law, RightHandSide& right_hand_side,
             StepMethod& method, StepObserver& observer) {
    if (!step.knows_modes || !observer.wants_peaks()) return observer.watch(step, law, at_start, at_end);
    constexpr int parts = 8;
    part_ = step;
    start_ = at_start;
    end_.resize(start_.size());
    for (int k = 1; k <= parts; ++k) {
      part_.end_phase = step.start_phase + k * (step.end_phase - step.start_phase) / parts;
      method.state_at(right_hand_side, step, part_.end_phase, part_.end);
      law(part_.end, part_.end_rate, part_.end_phase);
      for (std::size_t i = 0; i < start_.size(); ++i) end_[i] = law.kinematics(i, part_.end, part_.end_rate);
      observer.watch(part_, law, start_, end_);
      part_.turn_around();
      start_.swap(end_);
      part_.start_phase = part_.end_phase;
    }
  }

 private:
  Step part_;
  std::vector<contact::Kinematics> start_, end_;
};

}  // namespace rubsweep::integrate::adaptive
