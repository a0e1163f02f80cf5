#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// Point in the coordinates of continuation: state / sqrt(states), then parameter / parameter_scale.
using Position = Eigen::VectorXd;

Position position_of(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state, double parameter);
inline Position position_of(const orbits::OrbitProblem& problem, const BranchPoint& point) {
  return position_of(problem, point.state, point.parameter);
}

double parameter_of(const orbits::OrbitProblem& problem, const Position& position);
Eigen::VectorXd state_of(const Position& position);

/// Outcome of Newton's iteration.
struct NewtonOutcome {
  orbits::Evaluation evaluation = orbits::Evaluation::ok;
  bool converged = false;
  bool singular = false;  ///< true: the derivative is numerically singular
  int iterations = 0;
};

/// Outcome of Newton's iteration for an orbit.
struct Correction : NewtonOutcome {
  BranchPoint point;  ///< if converged: parameter, state and monodromy matrix
};

inline Position position_of(const orbits::OrbitProblem& problem, const Correction& found) {
  return position_of(problem, found.point);
}

/// Newton's iteration from `guess` for an orbit on the plane direction . (position - guess) = 0. The
/// derivative by the state is the monodromy matrix. The derivative by the parameter is a central difference
/// at the guess with the step `difference_step`.
Correction correct(const orbits::OrbitProblem& problem, const Position& guess,
                   const Eigen::VectorXd& direction, double difference_step = usual_difference_step);

/// Newton's iteration from a guess between two points of a branch, on the plane across the tangent of `from`.
/// Uses the smaller difference step of the two points.
Correction correct_between(const orbits::OrbitProblem& problem, const Position& guess,
                           const BranchPoint& from, const BranchPoint& to);

/// Newton's iteration for an orbit at a fixed parameter.
Correction correct_at(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state, double parameter);

/// Next Newton step from a converged orbit, on the plane across `direction`. The size of this step estimates
/// the error of the position due to rounding. Not finite where it cannot be computed.
Eigen::VectorXd next_step(const orbits::OrbitProblem& problem, const BranchPoint& point,
                          const Eigen::VectorXd& direction, double difference_step = usual_difference_step);

/// Error of the parameter due to rounding: size of the parameter component of next_step(). 0 where it cannot
/// be computed.
double rounding_of_parameter(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// Completes a converged orbit: its tangent on the side of `direction`, its multipliers and their counts. The
/// derivative by the parameter is computed at two step sizes. The two results differ where a step crosses a
/// graze. Smaller steps are then tried, and the pair with the best agreement is used. False where the tangent
/// cannot be determined or the map cannot be differentiated.
bool complete(const orbits::OrbitProblem& problem, const Eigen::VectorXd& direction, BranchPoint& point);

/// Completes an orbit that Newton's iteration found, with its facts and arclength; empty where an orbit
/// cannot be completed.
std::optional<BranchPoint> completed(const orbits::OrbitProblem& problem, Correction found,
                                     const Eigen::VectorXd& direction, double arclength);

/// Returns `position` itself, as the coordinates of an orbit contain no angle.
inline const Position& nearest_image(const orbits::OrbitProblem&, const Position& position,
                                     const BranchPoint&) {
  return position;
}

}  // namespace rubsweep::branch::continuation
