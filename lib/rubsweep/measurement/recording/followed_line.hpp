#pragma once

#include <optional>
#include <vector>

#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::recording {

/// Turns of a shaft whose speed changes, by its line in the readings alone.
struct FollowedTurns {
  std::vector<double> begin_s;  ///< instants at which turns begin; the first reading takes the mark's place
  double speed_uncertainty_hz = 0;     ///< standard, of the speed at an instant
  double angle_uncertainty_turns = 0;  ///< standard, of an angle beside those nearby
};

/// Follows the line of the shaft through short-time spectra, from near sweep.from_hz (within a quarter of it)
/// to near sweep.to_hz: of all paths whose steps are as small as an even sweep allows, four times over, the
/// one with the largest product of powers. The phase of the line along that path then gives the angles; near
/// a resonance they turn with the phase of the vibration. `probes` are readings on one clock from `first_s`
/// on; the one with the largest line decides. Empty where no line stands out of the noise along the path.
std::optional<FollowedTurns> follow_line(const std::vector<std::vector<double>>& probes, double first_s,
                                         double sampling_rate_hz, const Sweep& sweep);

}  // namespace rubsweep::recording
