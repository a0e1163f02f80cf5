#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/design/unbalance_response.hpp"

namespace rubsweep::design {

/// A peak of a response over the speed.
struct Resonance {
  double speed_hz = 0;
  double amplitude = 0;
  /// Speed of the peak / (N2 - N1), where the amplitude is that of the peak / sqrt 2 at N1 and N2 (API 617;
  /// API RP 684): twice the one side where the response falls so far on that alone; empty where it does on
  /// neither.
  std::optional<double> amplification;
  /// Empty amplification: the factor is below this, because the response does not fall that far within the
  /// range.
  double amplification_below = 0;
};

/// The peaks of `amplitude` between the first and the last of `speeds_hz`, ascending.
std::vector<Resonance> resonances(std::span<const double> speeds_hz,
                                  const std::function<double(double)>& amplitude);

/// Amplification below which a resonance counts as critically damped (API 617).
inline constexpr double critically_damped = 2.5;

/// Largest margin that API 617 asks of a resonance below the operating range, as a share of its lowest speed.
inline constexpr double largest_separation_below = 0.16;

/// Margin to the operating range that API 617 asks of a resonance, as a share of the nearer end of the range:
/// below it min(16, 17 (1 - 1 / (AF - 1.5))) %, above it min(26, 10 + 17 (1 - 1 / (AF - 1.5))) %; 0 below an
/// amplification of 2.5.
double required_separation(double amplification, bool above);

/// Distance of a speed from the range as a share of its nearer end; negative inside.
double separation(const SpeedRange& operating, double speed_hz);

}  // namespace rubsweep::design
