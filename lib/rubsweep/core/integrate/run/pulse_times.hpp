#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// Times of the half-sine pulses of a run, revolution by revolution. Any number of them may overlap. Behind
/// those of the scene come the parts of its second harmonic, which act from the first. Instants count from
/// the start of the revolution, in the time of a StateScale; no memory is allocated once they are made.
class PulseTimes {
 public:
  /// `period`: of a revolution, in the time of the scale.
  PulseTimes(const scene::Scene& scene, const StateScale& scale, double period);

  /// Goes to the start of a revolution. True: other pulses act there than did before.
  bool begin_turn(long revolution);
  /// Goes on to `time` in the revolution; true: from here on other pulses act than did before.
  bool go_to(double time) { return time >= next_change_ && look(time); }

  /// The soonest instant after the present one at which a pulse begins or ends; infinity when none will.
  double next_change() const { return next_change_; }
  /// Numbers of the pulses of the scene that act now, ascending.
  const std::vector<std::size_t>& acting() const { return acting_; }
  /// Angle of the half-sine of pulse `i` at `time` in the revolution, from 0 to pi while it acts; of a part
  /// of the second harmonic, that of its sine.
  double angle_rad(std::size_t i, double time) const;
  /// Time from the start of pulse `i` to that of the revolution.
  double elapsed(std::size_t i) const { return pulses_[i].elapsed; }

 private:
  struct Pulse {
    double duration = 0;          ///< 0: it has no force and never acts
    double elapsed_at_start = 0;  ///< time at the start of revolution 0; below 0: it begins later
    double elapsed = 0;           ///< time at the start of the present revolution
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

/// End of the last pulse of a scene, 0 where there is none.
double pulses_end_s(const scene::Scene& scene);

}  // namespace rubsweep::integrate::run
