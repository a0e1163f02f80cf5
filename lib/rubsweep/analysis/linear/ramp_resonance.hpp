#pragma once

#include <optional>
#include <span>

#include "rubsweep/analysis/linear/bode.hpp"

namespace rubsweep::linear {

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
/// resonance. Empty where the part has fewer than 16 points, where the speed turns back, and where no mode
/// with a damping ratio between 0 and 1 fits best at a speed inside the part. See docs/method/fits.md,
/// "Resonance of a ramp".
std::optional<RampResonance> fit_ramp_resonance(std::span<const BodePoint> plot, double rate_hz_per_s);

}  // namespace rubsweep::linear
