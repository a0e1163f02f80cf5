#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/modal_terms.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"

namespace rubsweep::integrate::exact::tube {

/// Numbers of the carried disturbances that span the fast part of a tube, and after them the slow one. The
/// rest are deflections at changes of mode.
struct PartSizes {
  std::size_t fast = 0, slow = 0;

  std::size_t all() const { return fast + slow; }
};

/// Spread from the values of these disturbances: those of the unit disturbances of either part count as one
/// Euclidean length, those of deflections as one number each.
TurnTube::Spread spread_of(const std::vector<double>& values, const PartSizes& base);

/// The largest over a step of `duration_s`: a length is convex, so that along a straight line it is largest
/// at an end.
TurnTube::Spread spread_over(const modes::ModalSums& seen, const PartSizes& base, double duration_s);

/// Makes `spread` as large as `other`, in what both have.
void raise(TurnTube::Spread& spread, const TurnTube::Spread& other);

}  // namespace rubsweep::integrate::exact::tube
