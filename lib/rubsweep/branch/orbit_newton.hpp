#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/branch/branch_point.hpp"
#include "rubsweep/branch/orbit_problem.hpp"

namespace rubsweep::branch {

/// A point in the coordinates of continuation: state / sqrt(states), then parameter / parameter_scale.
using Position = Eigen::VectorXd;

Position position_of(const OrbitProblem& problem, const Eigen::VectorXd& state, double parameter);
inline Position position_of(const OrbitProblem& problem, const BranchPoint& point) {
  return position_of(problem, point.state, point.parameter);
}

double parameter_of(const OrbitProblem& problem, const Position& position);
Eigen::VectorXd state_of(const Position& position);

/// Outcome of Newton's iteration.
struct Correction {
  Evaluation evaluation = Evaluation::ok;
  bool converged = false;
  int iterations = 0;
  BranchPoint point;  ///< converged: parameter, state and monodromy
};

/// Newton's iteration from `guess` for an orbit on the plane direction . (position - guess) = 0. The
/// derivative by the state is the monodromy matrix, that by the parameter a central difference at the guess,
/// of `difference_step`.
Correction correct(const OrbitProblem& problem, const Position& guess, const Eigen::VectorXd& direction,
                   double difference_step = usual_difference_step);

/// The same at a fixed parameter.
Correction correct_at(const OrbitProblem& problem, const Eigen::VectorXd& state, double parameter);

/// Fills what belongs to an orbit found: its tangent, on the side of `direction`, its multipliers and their
/// counts. The derivative by the parameter is made at two step sizes; where they disagree, as beside a graze
/// that one of them leads over, finer ones are tried, and those count that agree best. False where the
/// tangent cannot be told, or the map not be differentiated.
bool complete(const OrbitProblem& problem, const Eigen::VectorXd& direction, BranchPoint& point);

}  // namespace rubsweep::branch
