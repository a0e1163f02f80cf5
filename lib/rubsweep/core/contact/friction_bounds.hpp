#pragma once

#include <string>

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// Extremes of a friction coefficient over all slip speeds above zero, in any of its forms.
struct FrictionBounds {
  double smallest = 0;  ///< below 0: friction that drives the slip; -infinity: a falling viscous part
  double smallest_at_m_per_s = 0;
  double largest = 0;  ///< largest force without the viscous part
};

FrictionBounds friction_bounds(const model::Friction& friction);

/// Friction that brakes: nowhere below 0 and, without its viscous part, nowhere above the largest coefficient
/// that a constant friction may have.
bool brakes(const FrictionBounds& bounds);

/// Throws ConfigError where it does not; `path` is the friction's, e.g. "stops.0.friction".
void refuse_driving(const model::Friction& friction, const std::string& path);

}  // namespace rubsweep::contact
