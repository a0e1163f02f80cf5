#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// A point in the coordinates of continuation: state / sqrt(states), then parameter / parameter_scale.
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
  bool singular = false;  ///< the derivative has no inverse to speak of
  int iterations = 0;
};

/// Outcome of Newton's iteration for an orbit.
struct Correction : NewtonOutcome {
  BranchPoint point;  ///< converged: parameter, state and monodromy
};

inline Position position_of(const orbits::OrbitProblem& problem, const Correction& found) {
  return position_of(problem, found.point);
}

/// Newton's iteration from `guess` for an orbit on the plane direction . (position - guess) = 0. The
/// derivative by the state is the monodromy matrix, that by the parameter a central difference at the guess,
/// of `difference_step`.
Correction correct(const orbits::OrbitProblem& problem, const Position& guess,
                   const Eigen::VectorXd& direction, double difference_step = usual_difference_step);

/// The same from a guess between two points of a branch, across the tangent of the first, with the finer of
/// their difference steps.
Correction correct_between(const orbits::OrbitProblem& problem, const Position& guess,
                           const BranchPoint& from, const BranchPoint& to);

/// The same at a fixed parameter.
Correction correct_at(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state, double parameter);

/// The step that Newton's iteration would make next from an orbit found, across `direction`: in size the
/// error of its position by rounding. Not finite where that cannot be told.
Eigen::VectorXd next_step(const orbits::OrbitProblem& problem, const BranchPoint& point,
                          const Eigen::VectorXd& direction, double difference_step = usual_difference_step);

/// Size of that step as a change of the parameter; 0 where it cannot be told.
double rounding_of_parameter(const orbits::OrbitProblem& problem, const BranchPoint& point);

/// Fills what belongs to an orbit found: its tangent, on the side of `direction`, its multipliers and their
/// counts. The derivative by the parameter is made at two step sizes; where they disagree, as beside a graze
/// that one of them leads over, finer ones are tried, and those count that agree best. False where the
/// tangent cannot be told, or the map not be differentiated.
bool complete(const orbits::OrbitProblem& problem, const Eigen::VectorXd& direction, BranchPoint& point);

/// The orbit that Newton's iteration found, complete, with its facts and arclength. Empty where that cannot
/// be.
std::optional<BranchPoint> completed(const orbits::OrbitProblem& problem, Correction found,
                                     const Eigen::VectorXd& direction, double arclength);

/// Position itself: an orbit has no angle among its coordinates.
inline const Position& nearest_image(const orbits::OrbitProblem&, const Position& position,
                                     const BranchPoint&) {
  return position;
}

}  // namespace rubsweep::branch::continuation
