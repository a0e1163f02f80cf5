#pragma once

#include <optional>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// First orbit of twice the period near a period doubling, a short distance along the null vector of M + 1.
/// From this orbit `follow` follows the doubled branch away from the doubling. The opposite direction gives
/// the same branch, shifted by a period. `doubled`: problem with twice the turns. Empty where no orbit is
/// found.
std::optional<BranchPoint> doubled_start(const orbits::OrbitProblem& doubled, const BranchPoint& doubling);

/// Options of `follow`. Lengths are in the coordinates of continuation, see BranchPoint.
struct FollowOptions {
  double first_step = 1e-4, longest_step = 0.02, shortest_step = 1e-10;
  int most_points = 2000;             ///< limit on each side of the start
  bool stop_at_first_change = false;  ///< true: ends where stability changes, also at a fold
  /// false: only grazes at which the first contact appears or the last contact disappears
  bool every_graze = true;
};

/// Orbit that Newton's iteration finds from `state` at a fixed parameter, with its tangent towards rising
/// parameter. Empty where the iteration finds no orbit.
std::optional<BranchPoint> orbit_from(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state,
                                      double parameter);

BranchPoint turned_about(BranchPoint point);  ///< Reverses the tangent of a point.

/// Follows the branch from `start` along its tangent by pseudo-arclength continuation with adaptive steps.
HalfBranch follow(const orbits::OrbitProblem& problem, const BranchPoint& start,
                  const FollowOptions& options);

/// Follows the branch from `start` in both directions. A closed branch is followed in one direction.
Branch follow_both_ways(const orbits::OrbitProblem& problem, const BranchPoint& start,
                        const FollowOptions& options);

}  // namespace rubsweep::branch::continuation
