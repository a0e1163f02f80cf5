#pragma once

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// Lengths are those of the coordinates of the system.
struct CurveOptions {
  double first_step = 1e-3, longest_step = 0.02, shortest_step = 1e-9;
  int most_points = 2000;  ///< on each side of the start
};

/// Follows the curve through `start` both ways by pseudo-arclength continuation with adaptive steps, within
/// the ranges of both parameters; one that closes is followed one way.
Curve follow_curve(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options);

/// Whether `point` of the same system lies on a curve, at any of its turns.
bool lies_on(const ExtendedSystem& system, const Curve& curve, const CurvePoint& point);

}  // namespace rubsweep::branch::curves
