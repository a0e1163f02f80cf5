#pragma once

#include <algorithm>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::exact {

/// Sampling of an exact run. In modes with a modal form samples do not cut the run's steps: a second copy of
/// the state moves from sample to sample by the flow over one sampling interval. In other modes this flow
/// would be a full matrix; there the run ends a step at every sample.
template <int N>
class SampleWatch {
 public:
  using State = typename modes::ExactTypes<N>::State;

  void begin(const run::TurnRequest& request, run::TurnReport& report, double period_s, Eigen::Index states) {
    next_ = 0;
    visit_ = -1;
    count_ = request.samples_per_revolution;
    period_s_ = period_s;
    if (count_ > 0) report.samples.resize(static_cast<std::size_t>(count_ * states));
  }

  /// Continues after the samples of another solver in the report.
  void resume(const run::TurnReport& report) {
    next_ = report.sample_count;
    visit_ = -1;
  }

  bool wanted() const { return next_ < count_; }

  /// Whether the motion's mode requires samples between the ends of steps.
  bool ahead(const ExactMotion<N>& motion) const { return wanted() && motion.mode().paired; }

  /// Latest time at which the next step must end.
  double boundary_s(const ExactMotion<N>& motion) const {
    return wanted() && !motion.mode().paired ? due_s() : period_s_;
  }

  /// Notes a step that starts `time_s` into the turn; where nothing is wanted, the first of several steps.
  void start(const ExactMotion<N>& motion, double time_s, run::TurnReport& report,
             const run::StateScale& scale) {
    step_s_ = time_s;
    if (!wanted()) return;
    if (motion.mode().paired) {
      if (visit_ != motion.visits()) stand(motion, time_s);
    } else if (time_s >= due_s()) {
      put(motion.physical(), report, scale);
    }
  }

  /// Ends the latest step at `time_s`, still in its mode. Calls `look(state, seconds)` for every sample
  /// inside, with the time since the sample before or since the step's start. Returns the time after the last
  /// sample.
  template <class Look>
  double end(ExactMotion<N>& motion, double time_s, run::TurnReport& report, const run::StateScale& scale,
             const Look& look) {
    double last_s = step_s_;
    if (!ahead(motion)) return time_s - last_s;
    while (next_ < count_ && due_s() < time_s) {
      const double due = due_s();
      if (at_sample_) {
        motion.ahead_by_interval(instant_, period_s_ / count_);
      } else {
        motion.ahead(instant_, due - instant_s_);
        at_sample_ = true;
      }
      const State state = motion.physical(instant_);
      look(state, due - last_s);
      last_s = due;
      put(state, report, scale);
    }
    return time_s - last_s;
  }

 private:
  double due_s() const { return period_s_ * next_ / count_; }

  void put(State state, run::TurnReport& report, const run::StateScale& scale) {
    scale.from_seconds(state);
    std::copy(state.data(), state.data() + state.size(), report.samples.begin() + next_ * state.size());
    report.sample_count = ++next_;
  }

  /// Sets the instant at the start of a visit to a mode.
  void stand(const ExactMotion<N>& motion, double time_s) {
    visit_ = motion.visits();
    instant_ = motion.here();
    instant_s_ = time_s;
    at_sample_ = false;
  }

  typename ExactMotion<N>::Instant instant_;  ///< start of the visit, then the latest sample
  double instant_s_ = 0, step_s_ = 0, period_s_ = 0;
  long visit_ = -1;
  bool at_sample_ = false;
  int next_ = 0, count_ = 0;
};

}  // namespace rubsweep::integrate::exact
