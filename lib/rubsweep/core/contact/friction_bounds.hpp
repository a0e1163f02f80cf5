#pragma once

#include <string>

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// Extremes of a friction coefficient over all slip speeds above zero, for every kind of friction.
struct FrictionBounds {
  double smallest = 0;  ///< below 0: the friction drives the slip; -infinity: negative viscous slope
  double smallest_at_m_per_s = 0;
  double largest = 0;  ///< largest coefficient without the viscous part
};

FrictionBounds friction_bounds(const model::Friction& friction);

/// Whether the friction brakes: its coefficient is nowhere below 0 and, without its viscous part, nowhere
/// above the largest value allowed for a constant coefficient.
bool brakes(const FrictionBounds& bounds);

/// Throws ConfigError where the friction does not brake; `path` is its key, e.g. "stops.0.friction".
void refuse_driving(const model::Friction& friction, const std::string& path);

}  // namespace rubsweep::contact
