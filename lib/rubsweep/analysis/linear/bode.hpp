#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::linear {

/// One speed of a Bode plot: the component of a sensor's signal that turns with the shaft.
struct BodePoint {
  double speed_hz = 0;
  double amplitude_m = 0;
  /// Phase of the displacement against the instant at which the mark on the shaft passes the sensor: 0 to
  /// -360, negative values lag.
  double phase_deg = 0;
};

/// Readings of one sensor during a run-up, sample by sample.
struct OneXSignal {
  std::span<const std::complex<double>> phasor_m;  ///< A of the part Re(A e^{i phi}) at this instant
  std::span<const double> noise_m;                 ///< noise of the readings; empty: none
  std::span<const double> shaft_angle_rad;         ///< phi, rising
  std::span<const double> speed_hz;
  double sensor_angle_deg = 0;  ///< direction of the sensor, which the mark passes that much later
};

/// 1X of a run-up as a tracking filter shows it that looks at `revolutions` at once.
struct OneX {
  std::vector<BodePoint> plot;  ///< amplitudes A in the middle of the window, one per revolution
  double largest_amplitude_m = 0;
  /// Speed at which the amplitude was largest; empty where that is at an end of the plot, beyond which it may
  /// go on. On a fast ramp it is not the critical speed: the vibration comes later than the shaft.
  std::optional<double> speed_of_largest_hz;
};

/// The phasor is taken at the instant and not as the mean of a window, in which a resonance that is passed
/// through loses its top. The noise that a window leaves, by least squares of offset + Re(A e^{i phi}), is
/// added to it. A window with fewer than eight samples gives no point.
OneX one_x(const OneXSignal& signal, int revolutions);

}  // namespace rubsweep::linear
