#pragma once

#include <span>

#include "rubsweep/response/proof/adapted_norm.hpp"
#include "rubsweep/response/proof/patience.hpp"
#include "rubsweep/response/proof/periodic_orbit.hpp"
#include "rubsweep/response/proof/split_norms.hpp"

namespace rubsweep::response::proof {

/// Criteria for being near an orbit: any of these is enough.
struct Nearness {
  double adapted = 0;  ///< distance in the adapted norm of the turn
  double largest = 0;  ///< or this largest component of it, in (clearance, clearance omega)
  /// Or half of the first distance, by LinearConvergenceTest with the turns of three periods.
  bool converges = false;
};

/// Follows a transient, which is at `section` where the orbit is at its first section, turn by turn until it
/// is near the orbit. False when a turn fails, when it gets four times as far from the orbit as it was, and
/// when it takes more turns than `patience` allows.
bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, const Patience& patience);

/// The same until both parts of `norms` are within `radii`, with the distance in the norm that has these
/// radii as its ball. False after `most_turns`, too.
bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::tube::Parts& radii, double most_turns);

/// Distance of a section from the orbit's first one in the adapted norm there.
double adapted_distance(std::span<const double> section, const StableOrbit& orbit, const AdaptedNorms& norms);

}  // namespace rubsweep::response::proof
