#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace rubsweep::recording {

/// The integrations that made displacements from velocities or accelerations.
struct Integration {
  int times = 0;            ///< 0: displacement was measured
  double lowest_order = 0;  ///< orders below it are lost

  /// Noise of a line over that of the line at order 1: white noise of the readings falls with the order.
  double noise_at(double order) const {
    return times == 0 ? 1.0 : std::pow(std::max(std::abs(order), lowest_order), -times);
  }
};

/// Periods of a vibration within a window of `integrated` from which on it keeps 98.6 % of its size or more,
/// by the number of integrations.
inline constexpr double kept_periods[] = {0, 4, 5};

/// Readings integrated once or twice in time, so that a speed that changes moves no order. The integral is
/// that of the polynomial through six readings. What an offset of the readings and slow noise leave in it is
/// a polynomial in time, of as many degrees as there are integrations: it is fitted in windows of `window_s`
/// with weights cos^4, which no vibration of kept_periods or more in a window moves, and subtracted, and the
/// mean with it. Gaps (NaN) stay gaps; each stretch between them is integrated by itself, and is a gap if it
/// has fewer than `fewest_integrated` readings.
std::vector<double> integrated(std::span<const double> readings, double rate_hz, int times, double window_s);
inline constexpr std::size_t fewest_integrated = 16;

}  // namespace rubsweep::recording
