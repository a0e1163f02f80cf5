#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// All meetings between two neighbouring points of a curve, by ascending arclength. Meetings of multipliers
/// are roots of smooth functions along the curve, enclosed to 1e-12. Two simultaneous grazes, and a graze on
/// a curve of multipliers, are enclosed to the same width by bisection of the sequence of contact modes.
/// Empty where an orbit between the points is not found.
std::optional<std::vector<Meeting>> meetings_between(const ExtendedSystem& system, const CurvePoint& from,
                                                     const CurvePoint& to);

}  // namespace rubsweep::branch::curves
