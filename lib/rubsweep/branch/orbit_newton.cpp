#include "rubsweep/branch/orbit_newton.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "rubsweep/branch/multipliers.hpp"

namespace rubsweep::branch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int newton_iterations = 10;
constexpr double closed = 1e-12;        ///< return error of an orbit found, per unit of the state's size
constexpr double nearly_closed = 1e-9;  ///< the same where rounding or the solver's tolerance lets no better
/// Of the central difference by the parameter, in the coordinate of the parameter: the noise of a turn,
/// 1e-13, and the error of the formula both stay near 1e-7.
constexpr double difference_step = 1e-6;

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

double root_of_states(Eigen::Index states) { return std::sqrt(static_cast<double>(states)); }

/// d(image) / d(parameter coordinate) at one step size; one-sided where the other side has no machine.
bool difference(const OrbitProblem& problem, const VectorXd& state, double parameter, double step,
                VectorXd& slope) {
  const double h = step * problem.parameter_scale;
  VectorXd above = state, below = state;
  const bool has_above =
      problem.returns(parameter + h, above, nullptr) == Evaluation::ok && above.allFinite();
  const bool has_below =
      problem.returns(parameter - h, below, nullptr) == Evaluation::ok && below.allFinite();
  if (has_above && has_below) {
    slope = (above - below) / (2 * step);
    return true;
  }
  if (!has_above && !has_below) return false;
  VectorXd here = state;
  if (problem.returns(parameter, here, nullptr) != Evaluation::ok) return false;
  slope = has_above ? VectorXd((above - here) / step) : VectorXd((here - below) / step);
  return slope.allFinite();
}

/// [d(image)/d(state) - 1, d(image)/d(parameter); direction] in the coordinates of positions.
MatrixXd bordered(const MatrixXd& monodromy, const VectorXd& slope, const VectorXd& direction) {
  const Eigen::Index n = monodromy.rows();
  MatrixXd matrix(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = (monodromy - MatrixXd::Identity(n, n)) * root_of_states(n);
  matrix.topRightCorner(n, 1) = slope;
  matrix.bottomRows(1) = direction.transpose();
  return matrix;
}

}  // namespace

Position position_of(const OrbitProblem& problem, const VectorXd& state, double parameter) {
  Position position(state.size() + 1);
  position << state / root_of_states(state.size()), parameter / problem.parameter_scale;
  return position;
}

double parameter_of(const OrbitProblem& problem, const Position& position) {
  return position(position.size() - 1) * problem.parameter_scale;
}

VectorXd state_of(const Position& position) {
  const Eigen::Index states = position.size() - 1;
  return position.head(states) * root_of_states(states);
}

Correction correct(const OrbitProblem& problem, const Position& guess, const VectorXd& direction) {
  Correction found;
  const Eigen::Index n = guess.size() - 1;
  const bool parameter_moves = direction.head(n).cwiseAbs().maxCoeff() > 0;
  Position at = guess;
  VectorXd slope;
  double last = 0;
  for (int i = 0; i < newton_iterations; ++i) {
    found.iterations = i + 1;
    BranchPoint& point = found.point;
    point.parameter = parameter_of(problem, at);
    point.state = state_of(at);
    VectorXd image = point.state;
    found.evaluation = problem.returns(point.parameter, image, &point.monodromy);
    if (found.evaluation != Evaluation::ok) return found;
    const VectorXd defect = image - point.state;
    const double error = largest(defect) / std::max(1.0, largest(point.state));
    if (!std::isfinite(error)) return found;
    const bool stalled = i > 1 && error < nearly_closed && error > 0.1 * last;
    if (error < closed || stalled) {
      found.converged = true;
      return found;
    }
    if (i > 2 && error > last) return found;
    last = error;
    if (i == 0) {
      slope = VectorXd::Zero(n);
      if (parameter_moves && !difference(problem, point.state, point.parameter, difference_step, slope)) {
        found.evaluation = Evaluation::infeasible;
        return found;
      }
    }
    VectorXd right(n + 1);
    right << -defect, 0;
    const VectorXd step = bordered(point.monodromy, slope, direction).partialPivLu().solve(right);
    if (!step.allFinite()) return found;
    at += step;
  }
  return found;
}

Correction correct_at(const OrbitProblem& problem, const VectorXd& state, double parameter) {
  VectorXd along_parameter = VectorXd::Zero(state.size() + 1);
  along_parameter(state.size()) = 1;
  return correct(problem, position_of(problem, state, parameter), along_parameter);
}

bool complete(const OrbitProblem& problem, const VectorXd& direction, BranchPoint& point) {
  VectorXd wide, narrow;
  if (!difference(problem, point.state, point.parameter, difference_step, wide)) return false;
  if (!difference(problem, point.state, point.parameter, difference_step / 2, narrow)) return false;
  point.slope_difference = (wide - narrow).norm() / std::max(narrow.norm(), 1e-300);
  VectorXd right = VectorXd::Zero(direction.size());
  right(right.size() - 1) = 1;
  VectorXd tangent = bordered(point.monodromy, narrow, direction).partialPivLu().solve(right);
  if (!tangent.allFinite() || !(tangent.norm() > 0)) return false;
  tangent.normalize();
  if (tangent.dot(direction) < 0) tangent = -tangent;
  point.tangent = tangent;
  point.branching = bordered(point.monodromy, narrow, tangent).partialPivLu().determinant();
  point.multipliers = multipliers_of(point.monodromy);
  point.unstable = count_outside(point.multipliers);
  return true;
}

}  // namespace rubsweep::branch
