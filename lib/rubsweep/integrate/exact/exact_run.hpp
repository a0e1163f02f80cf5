#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rubsweep/integrate/exact/exact_motion.hpp"
#include "rubsweep/integrate/exact/peak_watch.hpp"
#include "rubsweep/integrate/exact/sample_watch.hpp"
#include "rubsweep/integrate/exact/slip_watch.hpp"
#include "rubsweep/integrate/exact/step_choice.hpp"
#include "rubsweep/integrate/run/impulses.hpp"
#include "rubsweep/integrate/run/pulse_times.hpp"
#include "rubsweep/integrate/run/turn.hpp"

namespace rubsweep::integrate::exact {

/// How a turn of an exact run ended.
enum class ExactEnding {
  ok,
  beyond,  ///< this turn has no closed form: touching an annular stop, friction not saturated, an undamped
           ///< resonance
  step_limit,
  non_finite,
};

/// A run between flat stops with saturated friction, without truncation error: inside a contact mode the
/// state follows the mode's exact flow, and mode switches are found by certified steps: a bound M on the
/// second derivative of every guard function g keeps g + g' t + M t^2 / 2 negative over the whole step, so
/// that no guard is missed, graze or not; a crossing is accepted where M proves g monotone up to it. Rings
/// are taken as far as they are not touched.
template <int N>
class ExactRun {
 public:
  /// `modes` must fit the scene.
  ExactRun(const scene::Scene& scene, std::shared_ptr<MachineModes<N>> modes, long max_steps_per_revolution);

  /// Integrates the next revolution. After `beyond` the run stands where the revolution began, and the
  /// report means nothing.
  ExactEnding advance(const run::TurnRequest& request, run::TurnReport& report);

  /// The next revolution starts from `section` (as TurnReport::section): another solver made the turns before
  /// it.
  void resume(std::span<const double> section);

  /// Back to the start of revolution 0, at another section.
  void restart(std::span<const double> section);

  /// Scaled state where the next revolution begins, as TurnReport::section.
  std::vector<double> section() const;
  /// The same without an allocation, once `section` has the room.
  void put_section(std::vector<double>& section) const;
  long revolution() const { return revolution_; }
  const run::Effort& effort() const { return effort_; }

 private:
  using Motion = ExactMotion<N>;
  using State = typename Motion::State;

  bool begin_turn(const run::TurnRequest& request, run::TurnReport& report);
  bool start_motion();
  ExactEnding end_turn(run::TurnReport& report);
  bool enter_by_state(const State& physical);
  ExactEnding go_on(run::TurnReport& report);
  double shorten_for_peaks(double step_s) const;
  ExactEnding reach_boundary(run::TurnReport& report, double boundary_s);
  double next_impulse_s() const { return impulses_.next_phase_rad() / speed_; }
  double next_boundary() const;
  double reach_s() const;
  bool peaks_by_steps() const;
  bool pass_boundary(run::TurnReport& report);
  bool apply_impulses(run::TurnReport& report);
  void passed(run::TurnReport& report, double duration_s);
  void watch(run::TurnReport& report, double duration_s);
  void land(run::TurnReport& report, std::size_t guard, double latest_s);
  bool switch_mode(run::TurnReport& report, std::size_t guard);

  bool slip_held(run::TurnReport& report, const State& here);
  bool renew_slip_watch(run::TurnReport& report, StepChoice& choice);

  Motion motion_;
  run::StateScale scale_;  ///< of sections
  double speed_ = 0, period_s_ = 0, turns_per_s_ = 0;
  run::PulseTimes pulses_;  ///< in seconds
  run::Impulses impulses_;
  SlipWatch<N> slip_;
  PeakWatch<N> peaks_;
  SampleWatch<N> samples_;
  long max_steps_ = 0;   ///< of a turn
  long step_limit_ = 0;  ///< of effort_.steps in this turn

  State turn_start_;  ///< physical
  long revolution_ = 0;
  bool goes_on_ = false;  ///< the motion stands where the last turn ended
  double time_s_ = 0;     ///< into the revolution
  bool peaks_wanted_ = false, switches_wanted_ = false;
  Eigen::Index tangents_ = 0;  ///< asked for in this turn
  int standstill_ = 0;
  run::Effort effort_;
};

extern template class ExactRun<2>;
extern template class ExactRun<4>;
extern template class ExactRun<6>;
extern template class ExactRun<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
