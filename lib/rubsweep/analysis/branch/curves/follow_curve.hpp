#pragma once

#include <optional>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// The system of the curve that goes on from an event, and its point there.
struct CurveStart {
  ExtendedSystem system;
  CurvePoint point;
};

/// `orbits` has the order of the event's branch and must outlive what is returned; `place` is that of the
/// event, whose phase is zero. Empty where the event's kind has no curve (has_curve()), or Newton's iteration
/// does not find the event again in the plane.
std::optional<CurveStart> curve_start(const orbits::PlaneOrbits& orbits,
                                      const continuation::BranchEvent& event,
                                      const orbits::PlanePoint& place);

/// Lengths are those of the coordinates of the system.
struct CurveOptions {
  double first_step = 1e-3, longest_step = 0.02, shortest_step = 1e-9;
  int most_points = 2000;  ///< limit on each side of the start
};

/// Follows the curve through `start` both ways by pseudo-arclength continuation with adaptive steps, within
/// the ranges of both parameters; one that closes is followed one way.
Curve follow_curve(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options);

/// Whether `point` of the same system lies on a curve, at any of its turns.
bool lies_on(const ExtendedSystem& system, const Curve& curve, const CurvePoint& point);

}  // namespace rubsweep::branch::curves
