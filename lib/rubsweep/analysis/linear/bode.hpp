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

/// Vibration mode that explains 1X on a speed ramp around its largest value.
struct RampResonance {
  double frequency_hz = 0;        ///< undamped
  double damping_ratio = 0;       ///< share of critical damping, 0..1
  double misfit = 0;              ///< square root of the unexplained share of the signal's energy, 0..1
  double from_hz = 0, to_hz = 0;  ///< range of speeds of the fit, in the order of the ramp
};

/// Fits a mode to 1X by its transient response to the ramp. A steady-state resonance curve would be wrong on
/// a fast ramp, where the response lags. `plot` has amplitude and phase at points of a speed that changes at
/// the constant rate `rate_hz_per_s`, not 0. The fit uses the part whose amplitude is above a quarter of the
/// largest value. Besides the unbalance the model has a bow, earlier free vibration, and other modes without
/// resonance. Empty if the part has fewer than 16 points or the speed turns back. Also empty if the best fit
/// is not a mode with a damping ratio between 0 and 1 at a speed inside the part. See docs/method/fits.md,
/// "Resonance of a ramp".
std::optional<RampResonance> fit_ramp_resonance(std::span<const BodePoint> plot, double rate_hz_per_s);

}  // namespace rubsweep::linear
