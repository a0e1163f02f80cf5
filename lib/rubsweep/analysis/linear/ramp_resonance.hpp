#pragma once

#include <optional>
#include <span>

#include "rubsweep/analysis/linear/bode.hpp"

namespace rubsweep::linear {

/// One vibration mode that explains the 1X of a speed ramp about its largest value.
struct RampResonance {
  double frequency_hz = 0;        ///< undamped
  double damping_ratio = 0;       ///< share of critical damping, 0..1
  double misfit = 0;              ///< root of the unexplained share of the signal's energy, 0..1
  double from_hz = 0, to_hz = 0;  ///< speeds between which it was fitted, in the order of the ramp
};

/// Fits a mode to 1X by the transient response of the mode to the ramp itself, not by a resonance curve of
/// steady speeds, which lags behind on a fast ramp. `plot` holds amplitude and phase at points of a speed
/// that changes evenly by `rate_hz_per_s`, which has the sign of that change and is not 0. The part is fitted
/// in which the amplitude stays above a quarter of its largest value. Besides the unbalance on the mode the
/// fit allows for a bow, for the free vibration that came before, and for what other modes add without
/// resonance. Empty with fewer than 16 points there, with a speed that turns back, or where no mode of 0 <
/// damping ratio < 1 fits best inside the speeds of that part. docs/method/fits.md, "Resonance of a ramp".
std::optional<RampResonance> fit_ramp_resonance(std::span<const BodePoint> plot, double rate_hz_per_s);

}  // namespace rubsweep::linear
