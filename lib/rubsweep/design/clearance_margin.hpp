#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::design {

/// Share of the smallest diametral clearance that the major axis may take (API 617, 9th edition; API RP 684).
inline constexpr double clearance_share = 0.75;

/// The tightest speed of one stop.
struct ClearanceMargin {
  std::size_t stop = 0;
  std::optional<double> position_m;  ///< along the shaft; empty: of a Jeffcott rotor
  double speed_hz = 0;               ///< at which the margin is smallest
  double major_axis_m = 0;           ///< there, from end to end
  double diametral_clearance_m =
      0;              ///< twice the smallest gap about the rotor's mean position; 0: it rests on the wall
  double margin = 0;  ///< 1 - major axis / (share of the clearance); below 0: too tight
};

/// The margin of each stop, each at the speed from the first to the last of `speeds_hz` that is worst for it.
/// Offsets of the stop and static loads take from its clearance as they do in a cell.
std::vector<ClearanceMargin> clearance_margins(const scene::PreparedMachine& prepared, double eccentricity_m,
                                               std::span<const double> speeds_hz);

}  // namespace rubsweep::design
