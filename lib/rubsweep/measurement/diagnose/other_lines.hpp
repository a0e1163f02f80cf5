#pragma once

#include <array>
#include <complex>
#include <span>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Largest shares of a motion's size (root mean square about its mean) that lines may have which no rub made:
/// unequal supports, couplings, run-out that was left. Each share is drawn anew, its logarithm evenly from
/// `smallest_share` on, and its phase.
struct OtherLines {
  double backward_1x = 0.2, order_2 = 0.1, order_3 = 0.03;
  static constexpr double smallest_share = 1e-3;
};

/// Size of a motion: root mean square about its mean, in the unit of the samples.
double size_of(std::span<const std::complex<double>> samples);

/// A line that no rub made.
struct OtherLine {
  int order = 0;
  std::complex<double> amplitude = 0;  ///< in the unit of the motion
};

/// Lines at -1X, 2X, -2X, 3X and -3X of a motion of this size.
std::array<OtherLine, 5> draw_other_lines(const OtherLines& lines, double size, RandomStream& random);

/// Adds lines at -1X, 2X and 3X that no rub made to a motion of this size.
void add_other_lines(std::span<std::complex<double>> samples, const OtherLines& lines, double size,
                     RandomStream& random);

}  // namespace rubsweep::diagnose
