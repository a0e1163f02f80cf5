#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/modal_terms.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"

namespace rubsweep::integrate::exact::tube {

/// Numbers of carried disturbances that span the fast part of a tube and, after them, the slow part. The
/// remaining disturbances are deflections at changes of mode.
struct PartSizes {
  std::size_t fast = 0, slow = 0;

  std::size_t all() const { return fast + slow; }
};

/// Spread from the values of these disturbances. The unit disturbances of each part give one Euclidean
/// length, deflections one number each.
TurnTube::Spread spread_of(const std::vector<double>& values, const PartSizes& base);

/// Largest spread over a step of `duration_s`. A length is convex, so that its maximum along a straight line
/// is at one of the ends.
TurnTube::Spread spread_over(const modes::ModalSums& seen, const PartSizes& base, double duration_s);

/// Raises `spread` to `other` in every number that both have.
void raise(TurnTube::Spread& spread, const TurnTube::Spread& other);

}  // namespace rubsweep::integrate::exact::tube
