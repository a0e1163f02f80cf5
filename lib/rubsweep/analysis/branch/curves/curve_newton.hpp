#pragma once

#include <optional>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::branch::curves {

/// Outcome of Newton's iteration on an extended system.
struct CurveCorrection : continuation::NewtonOutcome {
  continuation::Position at;
  Extended extended;  ///< at `at`
  double error = 0;   ///< see CurvePoint
};

/// Newton's iteration from `guess` on the plane direction . (position - guess) = 0, to rounding.
CurveCorrection correct(const ExtendedSystem& system, const continuation::Position& guess,
                        const continuation::Position& direction);

/// The same from a guess between two points of a curve, across the tangent of the first.
inline CurveCorrection correct_between(const ExtendedSystem& system, const continuation::Position& guess,
                                       const CurvePoint& from, const CurvePoint& /*to*/) {
  return correct(system, guess, from.tangent);
}

/// The point that Newton's iteration found, with its tangent on the side of `direction`, its multipliers and
/// its facts. Empty where the tangent cannot be told, or the orbit not be run.
std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const continuation::Position& direction, double arclength);

inline const continuation::Position& position_of(const ExtendedSystem&, const CurvePoint& point) {
  return point.at;
}
inline const continuation::Position& position_of(const ExtendedSystem&, const CurveCorrection& found) {
  return found.at;
}

/// `position` with the phase of a graze moved by whole turns to be next to that of `near`.
continuation::Position nearest_image(const ExtendedSystem& system, continuation::Position position,
                                     const CurvePoint& near);

/// The same point with its curve the other way round.
CurvePoint turned_about(CurvePoint point);

}  // namespace rubsweep::branch::curves
