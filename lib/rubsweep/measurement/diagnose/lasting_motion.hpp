#pragma once

#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose {

/// Turns of the shaft in which free vibration of a damped rotor falls to the share `left` of what it was: its
/// envelope is exp(-damping_ratio * natural angular frequency * time). At most a million.
int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left);

/// Turns without contact after which a motion counts as one that has fallen back to quiet whirling.
inline constexpr int turns_in_flight = 30;

/// Turns between the kick and the recording. A Jeffcott rotor's free vibration dies away to a two-hundredth
/// in them, but for slow decay: no more than `most_turns_before_recording`. A rotor kit waits as long as most
/// Jeffcott rotors do.
inline constexpr int fewest_turns_before_recording = 120, most_turns_before_recording = 400,
                     kit_turns_before_recording = 200;
int turns_before_recording(const model::Machine& machine, double speed_hz);

inline constexpr double most_order = 8;  ///< of lines that are looked at

/// A motion that a kick left, without a verdict on it: several times cheaper than SimulatedMotion.
struct LastingMotion {
  MotionLines lines{};                       ///< up to most_order
  response::motion::ContactFacts contact{};  ///< over the recorded turns
  double eccentricity_m = 0;
};

/// Runs a machine from its start for turns_before_recording() and records so many turns. Empty
/// where it touches nothing in them, fails, or cannot start.
std::optional<LastingMotion> rubbing_motion(const model::Machine& machine, double speed_hz,
                                            const scene::Unbalance& unbalance, int turns,
                                            response::spectrum::SpectrumWorkspace& workspace);

/// The same of a machine that touches nothing: its quiet motion.
std::optional<LastingMotion> motion_without_contact(const model::Machine& machine, double speed_hz,
                                                    const scene::Unbalance& unbalance, int turns,
                                                    response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose
