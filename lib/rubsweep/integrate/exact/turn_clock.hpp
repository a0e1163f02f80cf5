#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <numbers>

#include "rubsweep/integrate/run/impulses.hpp"
#include "rubsweep/integrate/run/pulse_times.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// Time within a revolution, and its events at instants that are known beforehand: its end, impulses,
/// beginnings and ends of pulses.
class TurnClock {
 public:
  /// `in_seconds`: the scale of the states that impulses act on.
  TurnClock(const scene::Scene& scene, const run::StateScale& in_seconds)
      : speed_(scene.speed_rad_per_s),
        period_s_(2 * std::numbers::pi / scene.speed_rad_per_s),
        turns_per_s_(1 / period_s_),
        pulses_(scene, in_seconds, period_s_),
        impulses_(scene) {}

  /// Goes to the start of a revolution. True: other pulses act there than did before.
  bool begin_turn(long revolution) {
    time_s_ = 0;
    if (!impulses_.none()) impulses_.begin_turn(revolution);
    return pulses_.begin_turn(revolution);
  }

  double time_s() const { return time_s_; }  ///< since the start of the revolution
  double phase_rad() const { return speed_ * time_s_; }
  double period_s() const { return period_s_; }
  bool turn_is_over() const { return !(time_s_ < period_s_); }
  double turns(double duration_s) const { return duration_s * turns_per_s_; }

  void go_on(double duration_s) { time_s_ += duration_s; }
  /// To an instant of the revolution; pulses stay as they are until `change_pulses`.
  void go_to(double time_s) { time_s_ = time_s; }
  void go_to_phase(double phase_rad) { time_s_ = phase_rad / speed_; }

  /// Next end of the turn, impulse, beginning or end of a pulse, in seconds as `time_s`.
  double next_boundary_s() const { return std::min({period_s_, next_impulse_s(), pulses_.next_change()}); }
  /// Sets the acting pulses from here on; true: others than before.
  bool change_pulses() { return pulses_.go_to(time_s_); }
  const run::PulseTimes& pulses() const { return pulses_; }

  bool impulse_is_due() const { return time_s_ >= next_impulse_s(); }
  /// Velocity jump of the impulse that is due, an increment of q' in m/s; the impulse is then past.
  const Eigen::VectorXd& take_impulse() { return impulses_.take(); }

 private:
  double next_impulse_s() const { return impulses_.next_phase_rad() / speed_; }

  double speed_, period_s_, turns_per_s_;
  double time_s_ = 0;
  run::PulseTimes pulses_;  ///< in seconds
  run::Impulses impulses_;
};

}  // namespace rubsweep::integrate::exact
