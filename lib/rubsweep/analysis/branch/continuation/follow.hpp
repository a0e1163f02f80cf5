#pragma once

#include <optional>
#include <vector>

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

/// Graze of an orbit at all its points at once (orbits::EvenContact). The branch has a corner there.
struct EvenGraze {
  BranchPoint before;               ///< orbit just before the graze
  std::vector<BranchEvent> events;  ///< event of each grazing contact, all at one point
  std::optional<BranchPoint>
      beyond;  ///< orbit just beyond the graze, with its tangent pointing away from the graze
};

/// First such graze within about `step` ahead of `here`, along its tangent. Close to the graze, rounding
/// decides the contact modes and therefore the derivative of the map. Orbits are therefore computed at a
/// distance, at penetrations that fall by equal factors. Parameter and state are extrapolated from them to
/// zero penetration. `parameter_error` is the difference of the last extrapolations, plus the effect of the
/// spread of the penetration on the parameter.
std::optional<EvenGraze> even_graze_ahead(const orbits::OrbitProblem& problem, const BranchPoint& here,
                                          double step);

/// Whether an even contact touches on one of the two orbits but not on the other.
bool even_contact_changes(const BranchPoint& a, const BranchPoint& b);

/// All events between two neighbouring points of a branch, by ascending arclength. Folds, branch points,
/// period doublings and tori are roots of smooth test functions: the parameter component of the tangent, the
/// determinant of the bordered derivative, det(M + 1), and the determinant of the bialternate product. The
/// branch joins the branch of half its period where the difference of the states half a period apart changes
/// sign. A graze lies where the sequence of contact modes changes; it is located as the root of the squared
/// duration of the new stretch, which is a smooth function. If these events do not explain a change in the
/// number of multipliers outside the unit circle, this change is located by bisection. The slopes of a test
/// function at the ends may suggest two roots in the step. The step is then divided where the function comes
/// nearest to zero, and both parts are searched in the same way. Empty where the branch between the points is
/// not continuous: an orbit between them is not found, or the points belong to different branches.
std::optional<std::vector<BranchEvent>> events_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to,
                                                       bool every_graze);

/// Changes of the sequence of contact modes between two points of a branch, by ascending arclength. Bisection
/// by the sequence ends when a single stretch of changes appears or disappears. The squared duration of this
/// stretch is smooth and zero at the graze. Its root is extrapolated from the side that has the stretch, and
/// enclosed by the sequences on both sides. If several changes coincide, or the sequences differ otherwise,
/// bisection continues to the end and the kind is `sequence`. Empty where the branch between the points is
/// not continuous.
std::optional<std::vector<BranchEvent>> grazes_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to);

}  // namespace rubsweep::branch::continuation
