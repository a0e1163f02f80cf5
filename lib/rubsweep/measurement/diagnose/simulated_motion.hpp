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

/// Turns of the shaft after which a damped free vibration has fallen to the share `left` of its first value:
/// its envelope is exp(-damping_ratio * natural angular frequency * time). At most a million.
int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left);

/// Number of turns without contact after which a motion counts as quiet whirl.
inline constexpr int turns_in_flight = 30;

/// Turns between the kick and the recording. During these turns the free vibration of a Jeffcott rotor decays
/// to 1/200, unless this takes longer than `most_turns_before_recording`. For a rotor kit their number is
/// about that of most Jeffcott rotors.
inline constexpr int fewest_turns_before_recording = 120, most_turns_before_recording = 400,
                     kit_turns_before_recording = 200;
int turns_before_recording(const model::Machine& machine, double speed_hz);

inline constexpr double most_order = 8;  ///< highest order of the lines used

/// A motion after a kick that is not classified, and therefore several times cheaper than SimulatedMotion.
struct LastingMotion {
  MotionLines lines{};                       ///< lines up to most_order
  response::motion::ContactFacts contact{};  ///< facts over the recorded turns
  double eccentricity_m = 0;
};

/// Runs a machine from its start for turns_before_recording() and then records `turns` turns. Empty where the
/// recorded turns have no contact, the run fails, it cannot start, or after the first turns a contact force
/// is larger than `most_force_n`, if there is such a limit.
std::optional<LastingMotion> rubbing_motion(const model::Machine& machine, double speed_hz,
                                            const scene::Unbalance& unbalance, int turns,
                                            response::spectrum::SpectrumWorkspace& workspace,
                                            std::optional<double> most_force_n = {});

/// Records the quiet motion of a machine in the same way; empty where it touches a stop.
std::optional<LastingMotion> motion_without_contact(const model::Machine& machine, double speed_hz,
                                                    const scene::Unbalance& unbalance, int turns,
                                                    response::spectrum::SpectrumWorkspace& workspace);

inline constexpr int samples_per_revolution = 128;

/// Limits for the number of turns between the classification of a motion and its recording. Between these
/// limits it is the number after which the free vibration has decayed to 1e-5. At the classification this
/// vibration may be ten times the quiet whirl, and a thousandth of it would appear as a separate line in a
/// recording. Motions that touch a stop wait for `most_turns_touching` turns at most, because contacts also
/// damp the vibration.
inline constexpr int fewest_turns_after_verdict = 40, most_turns_after_verdict = 2000,
                     most_turns_touching = 150;

/// A settled motion and its label.
struct SimulatedMotion {
  std::vector<std::complex<double>> displacement_m{};  ///< x + iy in metres, samples_per_revolution a turn
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order{};
  std::optional<response::motion::Proof> proof{};
  response::motion::ContactFacts contact{};  ///< facts over the recorded turns
  double eccentricity_m = 0, whirl_ratio = 0;
  /// false: the motion started at rest, because the quiet whirl touches a stop, or there is no kick
  bool kicked = false;
  bool rubs = false;  ///< touched a stop in the recorded turns
};

/// Runs a machine with a Jeffcott rotor from its start until its motion is classified, and further until the
/// free vibration has decayed. Then records `turns` turns. Empty where the run fails or cannot start.
std::optional<SimulatedMotion> simulate_motion(const model::Machine& machine, double speed_hz,
                                               const scene::Unbalance& unbalance, int turns,
                                               response::motion::Workspace& workspace);

}  // namespace rubsweep::diagnose
