#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// All meetings between two neighbouring points of a curve, by ascending arclength. Those of multipliers are
/// roots of functions that are smooth along the curve, enclosed to 1e-12; of two grazes at once, or of a
/// graze on a curve of multipliers, the place is found by bisection of the sequence of contact modes to the
/// same width. Empty where an orbit on the way is not found.
std::optional<std::vector<Meeting>> meetings_between(const ExtendedSystem& system, const CurvePoint& from,
                                                     const CurvePoint& to);

}  // namespace rubsweep::branch::curves
