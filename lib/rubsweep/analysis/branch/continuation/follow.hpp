#pragma once

#include <optional>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// First orbit of twice the period beside a period doubling, a small way along the vector whose sign every
/// period turns: from there `follow` follows the doubled branch away from the doubling. The other side of it
/// is the same branch shifted by a period. `doubled`: the problem with twice the turns. Empty where none is
/// found.
std::optional<BranchPoint> doubled_start(const orbits::OrbitProblem& doubled, const BranchPoint& doubling);

/// Lengths are those of the coordinates of continuation, see BranchPoint.
struct FollowOptions {
  double first_step = 1e-4, longest_step = 0.02, shortest_step = 1e-10;
  int most_points = 2000;             ///< limit on each side of the start
  bool stop_at_first_change = false;  ///< where the stability changes, a fold included
  bool every_graze = true;  ///< else only those at which the last contact goes or the first one comes
};

/// The orbit that Newton's iteration finds from `state` at a fixed parameter, with its tangent on the side of
/// rising parameter. Empty where it finds none.
std::optional<BranchPoint> orbit_from(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state,
                                      double parameter);

/// The same orbit with its branch the other way round.
BranchPoint turned_about(BranchPoint point);

/// Follows the branch from `start` along its tangent by pseudo-arclength continuation with adaptive steps.
HalfBranch follow(const orbits::OrbitProblem& problem, const BranchPoint& start,
                  const FollowOptions& options);

/// The same both ways. A branch that closes is followed one way.
Branch follow_both_ways(const orbits::OrbitProblem& problem, const BranchPoint& start,
                        const FollowOptions& options);

}  // namespace rubsweep::branch::continuation
