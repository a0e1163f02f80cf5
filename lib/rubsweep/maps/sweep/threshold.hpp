#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {

/// Numbers that a study of thresholds tries in every cell: those of the axis, ascending, then smaller and
/// smaller steps wherever rub begins or ends between two of them.
struct ThresholdScan {
  KeyAxis axis;
  double tolerance = 1e-3;  ///< tolerance of a beginning or an end, relative to it; > 0
};

/// Result of one trial value.
struct Probe {
  bool rubs = false;
  bool failed = false;
  std::string motion;  ///< class and order, such as "subharmonic 1/2"
};

/// Interval of numbers at all of which rub goes on, as far as the scan saw. Both ends were tried; where the
/// interval does not reach an end of the scan, the number next to it by the tolerance was tried as well, and
/// rub did not go on.
struct RubInterval {
  double from = 0, to = 0;
  std::vector<std::string> motions;  ///< motions in the order in which they come first
};

/// Intervals of numbers at which rub goes on: any number of them, none where it never does. An interval that
/// is narrower than a step of the scan may be missed.
struct Threshold {
  std::vector<RubInterval> intervals;  ///< ascending
  std::size_t probes = 0;              ///< numbers that were tried
  std::size_t failed = 0;              ///< number of runs that failed: they count as not rubbing
};

/// Scans and bisects. A change is closed in on until its two sides differ by no more than the tolerance times
/// the larger of them, or times a thousandth of the whole scan where it lies about zero.
Threshold find_threshold(const ThresholdScan& scan, const std::function<Probe(double)>& probe);

}  // namespace rubsweep::sweep
