#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/integrate/exact/turn_tube.hpp"

namespace rubsweep::integrate::exact {

/// A linear function of the state (a guard, a slip) applied to every disturbance that is carried: its values,
/// rates, and bounds of its second derivatives, one number per disturbance.
struct SeenByDisturbances {
  std::vector<double> value, rate, curvature;
};

/// The spread that these values mean: the first `base` of them belong to the unit disturbances that span the
/// tube and count as one Euclidean length, the others belong to the kicks at changes of mode, one number
/// each.
TurnTube::Spread spread_of(const std::vector<double>& values, std::size_t base);

/// The largest over a step of `duration_s`: a length is convex, so that along a straight line it is largest
/// at an end.
TurnTube::Spread spread_over(const SeenByDisturbances& seen, std::size_t base, double duration_s);

/// Makes `spread` as large as `other`, in what both have.
void raise(TurnTube::Spread& spread, const TurnTube::Spread& other);

}  // namespace rubsweep::integrate::exact
