#pragma once

#include <cmath>

namespace rubsweep::design {

/// Radius of the quiet whirl of a Jeffcott rotor / eccentricity, for the ratio of shaft speed to natural
/// frequency.
inline double amplification(double speed_ratio, double damping_ratio) {
  const double square = speed_ratio * speed_ratio;
  return square / std::hypot(1 - square, 2 * damping_ratio * speed_ratio);
}

}  // namespace rubsweep::design
