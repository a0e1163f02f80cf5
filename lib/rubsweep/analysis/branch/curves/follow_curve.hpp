#pragma once

#include <optional>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// System of the curve that continues an event, and its start point.
struct CurveStart {
  ExtendedSystem system;
  CurvePoint point;
};

/// Start of the curve that continues `event`. `orbits` must have the order of the event's branch and outlive
/// the result. `place` is the point of the event in the plane, with phase zero. Empty where the event's kind
/// has no curve (has_curve()), or Newton's iteration does not find the event again.
std::optional<CurveStart> curve_start(const orbits::PlaneOrbits& orbits,
                                      const continuation::BranchEvent& event,
                                      const orbits::PlanePoint& place);

/// Options of follow_curve. Lengths are in the coordinates of the system.
struct CurveOptions {
  double first_step = 1e-3, longest_step = 0.02, shortest_step = 1e-9;
  int most_points = 2000;  ///< limit on each side of the start
};

/// Follows the curve through `start` in both directions by pseudo-arclength continuation with adaptive steps,
/// within the ranges of both parameters. A closed curve is followed in one direction.
Curve follow_curve(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options);

/// Whether `point`, of the same system, lies on a curve, with any of its turns as the first.
bool lies_on(const ExtendedSystem& system, const Curve& curve, const CurvePoint& point);

}  // namespace rubsweep::branch::curves
