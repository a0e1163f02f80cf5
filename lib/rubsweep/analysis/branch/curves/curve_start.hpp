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

}  // namespace rubsweep::branch::curves
