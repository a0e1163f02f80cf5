#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {

/// Numbers that a study of thresholds tries in every cell: those of the axis, ascending, then bisection
/// between two of them if rub begins or ends there.
struct ThresholdScan {
  KeyAxis axis;
  double tolerance = 1e-3;  ///< relative tolerance of each begin or end of rub; > 0
};

/// Result of one trial value.
struct Probe {
  bool rubs = false;
  bool failed = false;
  std::string motion;  ///< class and order, such as "subharmonic 1/2"
};

/// Interval of numbers in which every number tried rubs. Both ends rub. The next number beyond an end, at the
/// distance of the tolerance, was tried and does not rub, unless the end is an end of the scan.
struct RubInterval {
  double from = 0, to = 0;
  std::vector<std::string> motions;  ///< motions in the order in which they first occur
};

/// All intervals with rub, which may be none. An interval narrower than a step of the scan may be missed.
struct Threshold {
  std::vector<RubInterval> intervals;  ///< ascending
  std::size_t probes = 0;              ///< numbers that were tried
  std::size_t failed = 0;              ///< number of runs that failed: they count as no rub
};

/// Scans and bisects. Bisection ends when both sides of a change differ by at most the tolerance times the
/// larger absolute value. Near zero, the tolerance times a thousandth of the scanned range is used instead if
/// it is larger.
Threshold find_threshold(const ThresholdScan& scan, const std::function<Probe(double)>& probe);

}  // namespace rubsweep::sweep
