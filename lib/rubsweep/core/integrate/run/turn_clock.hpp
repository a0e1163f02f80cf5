#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <numbers>

#include "rubsweep/core/integrate/run/impulses.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// Time within a revolution and its known events: its end, impulses, beginnings and ends of pulses. Time is
/// in seconds or in radians of the shaft.
class TurnClock {
 public:
  /// Time in seconds.
  static TurnClock in_seconds(const scene::Scene& scene, const StateScale& scale) {
    return {scene, scale.in_seconds(), scene.speed_rad_per_s, 2 * std::numbers::pi / scene.speed_rad_per_s};
  }
  /// Time in radians, the time unit of `scale`.
  static TurnClock in_radians(const scene::Scene& scene, const StateScale& scale) {
    return {scene, scale, 1, 2 * std::numbers::pi};
  }

  /// Goes to the start of a revolution that ends at `end`. Returns whether the acting pulses change there.
  bool begin_turn(long revolution, double end) {
    time_ = 0;
    end_ = end;
    if (!impulses_.none()) impulses_.begin_turn(revolution);
    return pulses_.begin_turn(revolution);
  }
  bool begin_turn(long revolution) { return begin_turn(revolution, period_); }

  double time() const { return time_; }  ///< time since the start of the revolution
  double phase_rad() const { return speed_ * time_; }
  double period() const { return period_; }
  bool turn_is_over() const { return !(time_ < end_); }
  double turns(double duration) const { return duration * turns_per_time_; }

  void go_on(double duration) { time_ += duration; }
  /// Goes to an instant of the revolution; acting pulses change only with `change_pulses`.
  void go_to(double time) { time_ = time; }
  void go_to_phase(double phase_rad) { time_ = phase_rad / speed_; }

  /// The next event: end of the turn, impulse, beginning or end of a pulse.
  double next_boundary() const { return std::min({end_, next_impulse(), pulses_.next_change()}); }
  /// Updates the acting pulses; returns whether they changed.
  bool change_pulses() { return pulses_.go_to(time_); }
  const PulseTimes& pulses() const { return pulses_; }

  bool impulse_is_due() const { return time_ >= next_impulse(); }
  /// Velocities q', in m/s, that the impulse at this instant adds.
  const Eigen::VectorXd& take_impulse() { return impulses_.take(); }

 private:
  /// `speed`: radians of the shaft per unit of time.
  TurnClock(const scene::Scene& scene, const StateScale& scale, double speed, double period)
      : speed_(speed),
        period_(period),
        turns_per_time_(1 / period),
        end_(period),
        pulses_(scene, scale, period),
        impulses_(scene) {}

  double next_impulse() const { return impulses_.next_phase_rad() / speed_; }

  double speed_, period_, turns_per_time_;
  double time_ = 0, end_;
  PulseTimes pulses_;
  Impulses impulses_;
};

}  // namespace rubsweep::integrate::run
