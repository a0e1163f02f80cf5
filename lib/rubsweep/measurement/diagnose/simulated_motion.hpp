#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::diagnose {

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
  response::motion::ContactFacts contact{};  ///< over the recorded turns
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
