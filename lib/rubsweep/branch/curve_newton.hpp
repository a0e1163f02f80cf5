#pragma once

#include <optional>

#include "rubsweep/branch/curve.hpp"

namespace rubsweep::branch {

/// Outcome of Newton's iteration on an extended system.
struct CurveCorrection {
  Evaluation evaluation = Evaluation::ok;
  bool converged = false;
  bool singular = false;  ///< the derivative has no inverse to speak of
  int iterations = 0;
  Position at;
  Extended extended;  ///< at `at`
  double error = 0;   ///< see CurvePoint
};

/// Newton's iteration from `guess` on the plane direction . (position - guess) = 0, to rounding.
CurveCorrection correct(const ExtendedSystem& system, const Position& guess, const Position& direction);

/// Completes what Newton's iteration found: tangent on the side of `direction`, multipliers, facts. Empty
/// where the tangent cannot be told, or the orbit not be run.
std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const Position& direction, double arclength);

/// The piece of a curve between two of its points, by the distance s along the tangent of the first.
class CurveSegment {
 public:
  CurveSegment(const ExtendedSystem& system, const CurvePoint& from, const CurvePoint& to);

  double length() const { return length_; }

  /// The point at 0 <= s <= length(). Empty where Newton's iteration does not find it.
  std::optional<CurvePoint> at(double s) const;

 private:
  const ExtendedSystem& system_;
  const CurvePoint &from_, &to_;
  double length_;
};

}  // namespace rubsweep::branch
