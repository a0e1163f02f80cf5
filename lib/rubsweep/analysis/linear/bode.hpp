#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::linear {

/// Point of a Bode plot at one speed: the component of a sensor's signal that rotates with the shaft.
struct BodePoint {
  double speed_hz = 0;
  double amplitude_m = 0;
  /// Phase of the displacement relative to the instant at which the mark on the shaft passes the sensor, from
  /// 0 to -360; negative values lag.
  double phase_deg = 0;
};

/// Readings of one sensor during a run-up, one for each sample.
struct OneXSignal {
  std::span<const std::complex<double>> phasor_m;  ///< A of the 1X part Re(A e^{i phi}) at each instant
  std::span<const double> noise_m;                 ///< noise of the readings; empty: none
  std::span<const double> shaft_angle_rad;         ///< phi, ascending
  std::span<const double> speed_hz;
  double sensor_angle_deg = 0;  ///< direction of the sensor; the mark passes it later by this angle
};

/// 1X of a run-up as shown by a tracking filter with windows of `revolutions` revolutions.
struct OneX {
  std::vector<BodePoint> plot;  ///< amplitude A in the middle of each window, one per revolution
  double largest_amplitude_m = 0;
  /// Speed at which the amplitude was largest; empty where it is largest at an end of the plot. On a fast
  /// ramp it is not the critical speed, because the vibration lags behind the speed.
  std::optional<double> speed_of_largest_hz;
};

/// Computes 1X from the phasor at one instant, since the mean over a window would flatten a resonance that is
/// passed quickly. The remaining noise of a window (by least squares of offset + Re(A e^{i phi})) is added. A
/// window with fewer than eight samples gives no point.
OneX one_x(const OneXSignal& signal, int revolutions);

}  // namespace rubsweep::linear
