#pragma once

#include <span>
#include <vector>

#include "rubsweep/measurement/recording/turn_marks.hpp"

namespace rubsweep::recording {

/// How far a mark may stand off its true instant, in samples: 1 where the edge falls between two samples,
/// which then say no more than that; a fifth where one sample stands on the edge; 0 where two do, for then
/// the straight line through them is the edge.
double mark_resolution(std::span<const double> signal, Mark mark, double threshold);

/// Farthest that a smooth curve may be from a mark that is known to a resolution, in resolutions: half of
/// one, and a little for the noise of the edge.
inline constexpr double smoothing_bound = 0.52;

/// Instants of marks on a smooth curve of time over turns.
struct SmoothMarks {
  std::vector<double> t_s;
  int degree = 0;  ///< of the polynomial, or of one as flexible as the spline; 0: marks stayed as they were
};

/// Instants of the marks freed of the sampling, which moves each of them by up to half of `resolution_s` to
/// either side. Curves of time over turns are tried from the simplest on: polynomials of degree 1 to 5, then
/// cubic splines of 2, 4, 8, ... equal pieces with four marks or more each. Taken is the one behind the first
/// that is never farther from the marks. Marks stay as they are where there is none, or the resolution is 0.
SmoothMarks smoothed_marks(std::span<const double> marks_s, double resolution_s);

}  // namespace rubsweep::recording
