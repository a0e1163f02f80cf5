#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubsweep::ramp {

/// A shaft speed that changes evenly, with an unbalance. The shaft's angle is phi = 2 pi (from t + rate t^2 /
/// 2).
struct SpeedRamp {
  double from_hz = 0, to_hz = 0;  ///< > 0
  double rate_hz_per_s = 0;       ///< with the sign of to - from, not 0
  double eccentricity_m = 0;

  double duration_s() const { return (to_hz - from_hz) / rate_hz_per_s; }
  double fastest_hz() const { return std::max(from_hz, to_hz); }
  double speed_hz(double t_s) const { return from_hz + rate_hz_per_s * t_s; }
  double angle_rad(double t_s) const {
    return 2 * std::numbers::pi * (from_hz * t_s + rate_hz_per_s * t_s * t_s / 2);
  }
  /// Time at which the shaft has made so many turns, at most as many as the ramp has.
  double time_s(double turns) const {
    return 2 * turns / (from_hz + std::sqrt(std::max(0.0, from_hz * from_hz + 2 * rate_hz_per_s * turns)));
  }
};

}  // namespace rubsweep::ramp
