#pragma once

#include <algorithm>
#include <limits>

#include "rubsweep/core/integrate/exact/peak_watch.hpp"
#include "rubsweep/core/integrate/exact/sample_watch.hpp"

namespace rubsweep::integrate::exact {

/// Observer of an exact turn: takes samples and peaks between the ends of steps, and limits the length of
/// steps.
template <int N>
class TurnWatch {
 public:
  using State = typename modes::ExactTypes<N>::State;

  explicit TurnWatch(const modes::MachineModes<N>& modes, const scene::Scene& scene, double period_s)
      : peaks_(modes, scene.length_scale_m), scale_(run::state_scale(scene)), period_s_(period_s) {}

  void begin_turn(const run::TurnRequest& request, run::TurnReport& report, Eigen::Index states) {
    samples_.begin(request, report, period_s_, states);
    peaks_wanted_ = request.peaks;
  }
  /// Continues after the part of the report made by another solver.
  void resume(const run::TurnReport& report) { samples_.resume(report); }

  /// Begins watching in the motion's present mode.
  void begin_motion(const ExactMotion<N>& motion) {
    if (peaks_wanted_) peaks_.begin(motion);
  }

  bool wanted() const { return peaks_wanted_ || samples_.wanted(); }

  /// Notes a step that starts `time_s` into the turn; where nothing is wanted, the first of several steps.
  void start_step(const ExactMotion<N>& motion, double time_s, run::TurnReport& report) {
    samples_.start(motion, time_s, report, scale_);
  }
  /// Latest end of the next step.
  double boundary_s(const ExactMotion<N>& motion) const { return samples_.boundary_s(motion); }
  /// Longest allowed landing.
  double reach_s(const ExactMotion<N>& motion) const {
    return peaks_by_steps(motion) ? peak_reach_s(motion) : motion.reach_s();
  }
  /// Longest allowed step that is not a landing.
  double longest_step_s(const ExactMotion<N>& motion) const {
    if (!peaks_wanted_) return std::numeric_limits<double>::infinity();
    double longest_s = samples_.ahead(motion) ? period_s_ : period_s_ / steps_per_turn_when_watched;
    if (peaks_by_steps(motion)) longest_s = std::min(longest_s, peak_reach_s(motion));
    return longest_s;
  }

  /// Ends the latest step, which lasted `duration_s` and ends at `time_s`, still in its mode.
  void end_step(ExactMotion<N>& motion, double time_s, double duration_s, run::TurnReport& report) {
    if (!wanted()) return;
    const double rest_s =
        samples_.end(motion, time_s, report, scale_, [&](const State& here, double passed_s) {
          if (peaks_wanted_) peaks_.pass(here, passed_s, report);
        });
    if (peaks_wanted_) peaks_.step(motion, duration_s, rest_s, report);
  }

 private:
  static constexpr double steps_per_turn_when_watched = 64;

  /// Whether peaks of a contact force or of a casing's displacement need short steps.
  bool peaks_by_steps(const ExactMotion<N>& motion) const {
    return peaks_wanted_ && !motion.mode().paired && (motion.mode().pushes || peaks_.watches_casings());
  }

  PeakWatch<N> peaks_;
  SampleWatch<N> samples_;
  run::StateScale scale_;  ///< scale of samples
  double period_s_;
  bool peaks_wanted_ = false;
};

}  // namespace rubsweep::integrate::exact
