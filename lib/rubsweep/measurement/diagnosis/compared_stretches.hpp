#pragma once

#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::diagnosis {

/// Limits of the number of compared turns. 12 and 30 turns hold whole periods of many fractions of the speed.
inline constexpr int most_turns = 30, fewest_turns = 12;

/// Turns of a recording that are compared with simulated motions.
struct Stretch {
  int first_turn = 0, turns = 0;
  double speed_hz = 0;
  bool of_run_up = false;  ///< whether the speed of the recording changes
};

/// Stretches to compare, all of the same number of turns, the first one being the most important. Of a steady
/// recording these are its last turns. Of a run-up or coast-down it is the stretch with the largest lasting
/// share of energy off +-1X, and up to two others whose speeds differ the most from those taken before. A
/// stretch has so many turns that the order of a fixed frequency near 1X moves by no more than 0.6 lines, and
/// its two halves have similar sizes, if there are such stretches. Throws ConfigError with `name` for fewer
/// turns than fewest_turns, and where the speed changes faster.
std::vector<Stretch> compared_stretches(const recording::Recording& recording, const std::string& name);

/// Lines of a stretch, up to the largest order that its readings show. In a run-up
/// the linear growth of the mean and of the lines at +-1X is subtracted first.
diagnose::MotionLines lines_of(const recording::Recording& recording, const Stretch& stretch);

}  // namespace rubsweep::diagnosis
