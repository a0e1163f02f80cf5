#include "rubsweep/core/integrate/run/pulse_times.hpp"

#include <algorithm>
#include <numbers>

#include "rubsweep/core/integrate/run/second_harmonic.hpp"

namespace rubsweep::integrate::run {

PulseTimes::PulseTimes(const scene::Scene& scene, const StateScale& scale, double period) : period_(period) {
  for (const scene::Pulse& pulse : scene.pulses) {
    pulses_.push_back({.duration = pulse.force_n != 0 ? scale.duration(pulse.duration_s) : 0,
                       .elapsed_at_start = scale.duration(pulse.elapsed_s)});
  }
  for (const HarmonicPart& part : second_harmonic(scene)) {
    const double elapsed = period * part.turns_ahead;
    pulses_.push_back({.duration = period / 4,
                       .elapsed_at_start = elapsed,
                       .elapsed = elapsed,
                       .acts = true,
                       .always = true});
  }
  acting_.reserve(pulses_.size());
  list_acting();
}

bool PulseTimes::begin_turn(long revolution) {
  if (pulses_.empty()) return false;
  for (Pulse& pulse : pulses_) {
    if (!pulse.always) pulse.elapsed = period_ * static_cast<double>(revolution) + pulse.elapsed_at_start;
  }
  return look(0);
}

/// Updates which pulses act. A pulse acts from its beginning up to, but not including, its end: an instant at
/// which a run stops belongs to the time after it.
bool PulseTimes::look(double time) {
  bool changed = false;
  next_change_ = std::numeric_limits<double>::infinity();
  for (Pulse& pulse : pulses_) {
    if (pulse.duration == 0 || pulse.always) continue;
    const double begin = -pulse.elapsed, end = pulse.duration - pulse.elapsed;
    const bool acts = begin <= time && time < end;
    changed = changed || acts != pulse.acts;
    pulse.acts = acts;
    if (begin > time) next_change_ = std::min(next_change_, begin);
    if (end > time) next_change_ = std::min(next_change_, end);
  }
  if (changed) list_acting();
  return changed;
}

void PulseTimes::list_acting() {
  acting_.clear();
  for (std::size_t i = 0; i < pulses_.size(); ++i) {
    if (pulses_[i].acts) acting_.push_back(i);
  }
}

double PulseTimes::angle_rad(std::size_t i, double time) const {
  return std::numbers::pi * (pulses_[i].elapsed + time) / pulses_[i].duration;
}

double pulses_end_s(const scene::Scene& scene) {
  double end_s = 0;
  for (const scene::Pulse& pulse : scene.pulses) end_s = std::max(end_s, pulse.duration_s - pulse.elapsed_s);
  return end_s;
}

}  // namespace rubsweep::integrate::run
