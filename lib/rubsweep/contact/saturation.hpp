#pragma once

#include <optional>

#include "rubsweep/model/friction.hpp"

namespace rubsweep::contact {

/// Friction whose coefficient no longer depends on the slip speed.
struct SaturatedFriction {
  double coefficient = 0;
  double above_m_per_s = 0;  ///< holds for slip speeds above this; -infinity: for all
};

/// The limit of `friction` at large positive slip: no friction and a constant coefficient at every speed; a
/// Stribeck curve without viscous part (g6 = 0) where every tanh differs from 1 by less than 2e-12, g1's pair
/// cancelling. Empty for a viscous part or a tanh that never saturates: then the coefficient always varies.
std::optional<SaturatedFriction> saturated_friction(const model::Friction& friction);

}  // namespace rubsweep::contact
