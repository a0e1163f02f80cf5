#pragma once

#include <optional>
#include <span>
#include <vector>

namespace rubsweep::identify {

/// One speed of a Bode plot: the component of a sensor's signal that turns with the shaft.
struct BodePoint {
  double speed_hz = 0;
  double amplitude_m = 0;
  /// Of the displacement against the instant at which the mark on the shaft passes the sensor: 0 to -360,
  /// negative values lag.
  double phase_deg = 0;
};

/// Splits a run-up into windows of `revolutions` and fits offset + Re(A e^{i phi}) to each. `shaft_angle_rad`
/// rises along the samples; `speed_hz` is that of each sample; `sensor_angle_deg` the sensor's direction,
/// which the mark passes that much later. A window with fewer than eight samples gives no point.
std::vector<BodePoint> bode_plot(std::span<const double> displacement_m,
                                 std::span<const double> shaft_angle_rad, std::span<const double> speed_hz,
                                 double sensor_angle_deg, int revolutions);

/// Speed of the largest amplitude, by a parabola through the largest point and its neighbours; empty where
/// that is at an end of the plot, beyond which it may go on.
std::optional<double> critical_speed_hz(const std::vector<BodePoint>& plot);

}  // namespace rubsweep::identify
