#pragma once

#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {

/// Probability of "none of these" before a recording is looked at.
inline constexpr double prior_of_none = 1.0 / 6;

/// Vibration of a cause that no candidate stands for: unbalance, and one to four further components at any
/// order, each forward or backward in any share, nearly a circle, or along one line with its harmonics. They
/// may have sidebands at the shaft speed and a phase that wanders. Its lines up to most_order, in units of
/// that at 1X; all numbers are drawn.
MotionLines vibration_of_another_cause(int turns, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose::inference
