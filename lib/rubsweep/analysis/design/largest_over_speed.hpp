#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"

namespace rubsweep::design {

/// Speeds of a shaft, 0 < from_hz < to_hz.
struct SpeedRange {
  double from_hz = 0, to_hz = 0;

  bool contains(double speed_hz) const { return speed_hz >= from_hz && speed_hz <= to_hz; }
};

/// Where a quantity is largest over the speed.
struct Largest {
  double speed_hz = 0;
  double value = 0;
};

/// Speeds of a range at which a response is sampled, ascending: evenly spaced, and closer about critical
/// speeds, by the width of their resonances.
std::vector<double> response_speeds(const SpeedRange& range, std::span<const linear::CriticalSpeed> critical);

/// The largest `value` from the first to the last of `speeds_hz`, ascending: of the samples, and of what lies
/// between the two neighbours of each sample that is larger than both (Brent). A value that is not finite
/// counts as infinite.
Largest largest_over_speed(std::span<const double> speeds_hz, const std::function<double(double)>& value);

}  // namespace rubsweep::design
