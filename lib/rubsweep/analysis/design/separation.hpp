#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/design/unbalance_response.hpp"

namespace rubsweep::design {

/// A peak of a response as a function of the speed.
struct Resonance {
  double speed_hz = 0;
  double amplitude = 0;
  /// Speed of the peak / (N2 - N1); at N1 and N2 the amplitude is 1 / sqrt 2 of the peak (API 617; API RP
  /// 684). Where the response falls this far on one side only, twice the distance to that side takes the
  /// place of N2 - N1. Empty where it does so on neither side.
  std::optional<double> amplification;
  /// Upper bound of the amplification where `amplification` is empty, because the response does not fall far
  /// enough within the range.
  double amplification_below = 0;
};

/// The peaks of `amplitude` between the first and the last of `speeds_hz`, which ascend.
std::vector<Resonance> resonances(std::span<const double> speeds_hz,
                                  const std::function<double(double)>& amplitude);

/// Amplification below which a resonance counts as critically damped (API 617).
inline constexpr double critically_damped = 2.5;

/// Largest margin that API 617 requires of a resonance below the operating range, as a share of its lowest
/// speed.
inline constexpr double largest_separation_below = 0.16;

/// Margin to the operating range that API 617 requires of a resonance, as a share of the nearer end of the
/// range. Below the range it is min(16, 17 (1 - 1 / (AF - 1.5))) %, above it min(26, 10 + 17 (1 - 1 / (AF -
/// 1.5))) %. It is 0 for amplifications AF below 2.5.
double required_separation(double amplification, bool above);

/// Distance of a speed from the range, as a share of the range's nearer end; negative inside.
double separation(const SpeedRange& operating, double speed_hz);

}  // namespace rubsweep::design
