#pragma once

#include <optional>

#include "rubsweep/branch/branch_point.hpp"
#include "rubsweep/branch/orbit_newton.hpp"

namespace rubsweep::branch {

/// The piece of a branch between two of its points, by the distance s along the tangent of the first.
class Segment {
 public:
  Segment(const OrbitProblem& problem, const BranchPoint& from, const BranchPoint& to);

  /// Orbits at two neighbouring places, which are enclosed between these, belong to one branch.
  static bool continuous(const OrbitProblem& problem, const BranchPoint& a, const BranchPoint& b);

  /// Distance of the end; > 0 where `to` lies ahead of `from`.
  double length() const { return length_; }

  /// The orbit at 0 <= s <= length(), with its tangent, multipliers and facts. Empty where Newton's iteration
  /// does not find it. `near`: another point of the segment, or none.
  std::optional<BranchPoint> at(double s) const;

 private:
  const OrbitProblem& problem_;
  const BranchPoint &from_, &to_;
  Position begin_, end_;
  double length_;
};

/// Completes an orbit that Newton's iteration found: tangent on the side of `direction`, multipliers, facts,
/// arclength. Empty where that cannot be.
std::optional<BranchPoint> completed(const OrbitProblem& problem, BranchPoint point,
                                     const Eigen::VectorXd& direction, double arclength);

}  // namespace rubsweep::branch
