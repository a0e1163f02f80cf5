#pragma once

#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {

inline constexpr double prior_of_none = 1.0 / 6;  ///< Prior probability of "none of these".

/// Random vibration of a cause that is none of the candidates: unbalance plus one to four components of any
/// order. Each component is elliptic, nearly circular, or along one line with harmonics; it may have
/// sidebands at the shaft speed and a wandering phase. Returns the lines up to most_order in units of the
/// amplitude at 1X.
MotionLines vibration_of_another_cause(int turns, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose::inference
