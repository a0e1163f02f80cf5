#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// Times of the half-sine pulses of a run, revolution by revolution; pulses may overlap. The parts of the
/// scene's second harmonic follow its pulses; they act from the beginning. Instants are measured from the
/// start of the revolution in the time unit of a StateScale. No memory is allocated after construction.
class PulseTimes {
 public:
  /// `period`: duration of a revolution in the time unit of the scale.
  PulseTimes(const scene::Scene& scene, const StateScale& scale, double period);

  /// Goes to the start of a revolution. Returns whether the set of acting pulses changes there.
  bool begin_turn(long revolution);
  /// Goes to `time` in the revolution; returns whether the set of acting pulses changes there.
  bool go_to(double time) { return time >= next_change_ && look(time); }

  /// The next instant at which a pulse begins or ends; infinity when there is none.
  double next_change() const { return next_change_; }
  /// Indices of the pulses that act now, ascending.
  const std::vector<std::size_t>& acting() const { return acting_; }
  /// Angle of the half-sine of pulse `i` at `time` in the revolution, from 0 to pi while it acts; for a part
  /// of the second harmonic, the angle of its sine.
  double angle_rad(std::size_t i, double time) const;
  /// Time from the start of pulse `i` to the start of the revolution.
  double elapsed(std::size_t i) const { return pulses_[i].elapsed; }

 private:
  struct Pulse {
    double duration = 0;          ///< 0: the pulse has no force and never acts
    double elapsed_at_start = 0;  ///< elapsed time at the start of revolution 0; below 0: it begins later
    double elapsed = 0;           ///< elapsed time at the start of the present revolution
    bool acts = false;
    bool always = false;
  };

  bool look(double time);
  void list_acting();

  std::vector<Pulse> pulses_;
  double period_ = 0;
  std::vector<std::size_t> acting_;
  double next_change_ = std::numeric_limits<double>::infinity();
};

/// End of the last pulse of a scene in seconds; 0 without pulses.
double pulses_end_s(const scene::Scene& scene);

}  // namespace rubsweep::integrate::run
