#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Vibration of a cause that is none of the candidates, in units of the amplitude at 1X.
struct OtherVibration {
  std::vector<std::complex<double>> samples{};  ///< x + iy at equal steps of the shaft angle
  std::string parts{};  ///< kinds of its components, joined by +: unequal_supports, multiples, ...
};

/// Random vibration of `count` samples: unbalance plus one to four components of any order. Each component is
/// elliptic, nearly circular, or along one line with harmonics; it may have sidebands at the shaft speed and
/// a wandering phase.
OtherVibration another_cause(std::size_t count, int samples_of_a_turn, RandomStream& random);

/// Lines of such a vibration over whole turns, up to most_order.
MotionLines vibration_of_another_cause(int turns, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace);

/// Lines of the same machine at another speed: in one of three cases no more than 1X is left, in another the
/// same lines with other amplitudes, and in the third another vibration. Its size is 0.1 to 10 times as
/// large.
MotionLines vibration_at_another_speed(const MotionLines& lines, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace);

}  // namespace rubsweep::diagnose
