#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
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

inline constexpr double most_order = 8;  ///< highest order of lines that are looked at

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

inline constexpr int samples_per_revolution = 128;

/// Most and fewest turns that pass between the verdict on a motion and its recording; in between those in
/// which free vibration falls to a hundred thousandth. The verdict comes while it is still dying away, and
/// may find ten times the quiet whirl: a thousandth of that would stand in a recording as a line of its own.
/// Motions that touch a stop are not waited for longer than `most_turns_touching`, as contacts damp them,
/// too.
inline constexpr int fewest_turns_after_verdict = 40, most_turns_after_verdict = 2000,
                     most_turns_touching = 150;

/// A settled motion and its label.
struct SimulatedMotion {
  /// x + iy in metres, samples_per_revolution of every turn.
  std::vector<std::complex<double>> displacement_m{};
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order{};
  std::optional<response::motion::Proof> proof{};
  response::motion::ContactFacts contact{};  ///< facts over the recorded turns
  double eccentricity_m = 0, whirl_ratio = 0;
  bool kicked = false;  ///< false: it started at rest, as the quiet whirl touches a stop, or has no kick
  bool rubs = false;    ///< touched a stop in the recorded turns
};

/// Runs a machine with a Jeffcott rotor from its start until its motion is known, on until its free vibration
/// has died away, and then records so many turns. Empty where the run fails, or cannot start.
std::optional<SimulatedMotion> simulate_motion(const model::Machine& machine, double speed_hz,
                                               const scene::Unbalance& unbalance, int turns,
                                               response::motion::Workspace& workspace);

}  // namespace rubsweep::diagnose
