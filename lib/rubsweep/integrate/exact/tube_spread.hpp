#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/integrate/exact/turn_tube.hpp"

namespace rubsweep::integrate::exact {

/// What something linear in the state makes of every disturbance that is carried: values, rates and bounds of
/// the second derivatives.
struct SeenByDisturbances {
  std::vector<double> value, rate, curvature;
};

/// The first `base` numbers, of the unit disturbances, as one length, and the others, of kicks, each by
/// itself.
TurnTube::Spread spread_of(const std::vector<double>& values, std::size_t base);

/// The largest over a step of `duration_s`: a length is convex, so that along a straight line it is largest
/// at an end.
TurnTube::Spread spread_over(const SeenByDisturbances& seen, std::size_t base, double duration_s);

/// Makes `spread` as large as `other`, in what both have.
void raise(TurnTube::Spread& spread, const TurnTube::Spread& other);

}  // namespace rubsweep::integrate::exact
