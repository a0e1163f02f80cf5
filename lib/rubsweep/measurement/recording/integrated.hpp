#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
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

/// Samples at equal angles over whole turns, integrated over the angle: each line is divided by (i
/// order)^times, and lines below the lowest order are left out.
std::vector<std::complex<double>> integrated(std::vector<std::complex<double>> samples, int turns,
                                             const Integration& integration);

}  // namespace rubsweep::recording
