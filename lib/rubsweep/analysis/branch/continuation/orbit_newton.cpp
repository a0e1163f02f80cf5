#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rubsweep/analysis/branch/orbits/multipliers.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/newton.hpp"

namespace rubsweep::branch::continuation {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits newton_limits{.iterations = 10, .free_iterations = 3, .growth = 1};
constexpr double closed = 1e-12;        ///< return error of a converged orbit, per unit of the state's size
constexpr double nearly_closed = 1e-9;  ///< tolerance where rounding or the solver permits no smaller error
constexpr double finest_difference_step = 1e-9;
constexpr double agreement = 1e-4;  ///< relative difference of derivatives at two step sizes

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

double root_of_states(Eigen::Index states) { return std::sqrt(static_cast<double>(states)); }

/// One-sided difference d(image) / d(parameter coordinate); for `step` > 0 towards greater parameters.
bool one_sided_difference(const orbits::OrbitProblem& problem, const VectorXd& state, double parameter,
                          double step, VectorXd& slope) {
  VectorXd beside = state, here = state;
  if (problem.returns(parameter + step * problem.parameter_scale, beside, nullptr) !=
          orbits::Evaluation::ok ||
      problem.returns(parameter, here, nullptr) != orbits::Evaluation::ok)
    return false;
  slope = (beside - here) / step;
  return slope.allFinite();
}

/// Central difference; one-sided where the machine does not exist on the other side.
bool difference(const orbits::OrbitProblem& problem, const VectorXd& state, double parameter, double step,
                VectorXd& slope) {
  const double h = step * problem.parameter_scale;
  VectorXd above = state, below = state;
  const bool has_above =
      problem.returns(parameter + h, above, nullptr) == orbits::Evaluation::ok && above.allFinite();
  const bool has_below =
      problem.returns(parameter - h, below, nullptr) == orbits::Evaluation::ok && below.allFinite();
  if (has_above && has_below) {
    slope = (above - below) / (2 * step);
    return true;
  }
  if (!has_above && !has_below) return false;
  return one_sided_difference(problem, state, parameter, has_above ? step : -step, slope);
}

/// Derivative by the parameter, with the largest step for which half the step gives the same derivative. If a
/// graze is nearer than the finest step, the one-sided difference with the best agreement is taken.
bool best_difference(const orbits::OrbitProblem& problem, BranchPoint& point, VectorXd& slope) {
  double least = std::numeric_limits<double>::infinity();
  VectorXd wide, narrow;
  const auto take = [&](double step, double half_weight) {
    const double apart = (wide - narrow).norm() / std::max(narrow.norm(), 1e-300);
    if (!(apart < least)) return;
    least = point.slope_difference = apart;
    point.difference_step = step;
    slope = narrow + half_weight * (narrow - wide);
  };
  for (double step = usual_difference_step; step >= finest_difference_step && least > agreement; step /= 10) {
    if (!difference(problem, point.state, point.parameter, step, wide) ||
        !difference(problem, point.state, point.parameter, step / 2, narrow))
      break;
    take(step, 0);
  }
  if (!std::isfinite(least)) return false;
  if (least <= agreement) return true;
  for (const double side : {usual_difference_step, -usual_difference_step}) {
    if (one_sided_difference(problem, point.state, point.parameter, side, wide) &&
        one_sided_difference(problem, point.state, point.parameter, side / 2, narrow))
      take(finest_difference_step, 1);  // two steps cancel the error, which is linear in the step
  }
  return true;
}

/// Bordered matrix [d(image)/d(state) - 1, d(image)/d(parameter); direction] in the coordinates of positions.
MatrixXd bordered(const MatrixXd& monodromy, const VectorXd& slope, const VectorXd& direction) {
  const Eigen::Index n = monodromy.rows();
  MatrixXd matrix(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = (monodromy - MatrixXd::Identity(n, n)) * root_of_states(n);
  matrix.topRightCorner(n, 1) = slope;
  matrix.bottomRows(1) = direction.transpose();
  return matrix;
}

/// Newton's iteration for an orbit; the unknown is the position.
class OrbitIteration {
 public:
  OrbitIteration(const orbits::OrbitProblem& problem, const Position& guess, const VectorXd& direction,
                 double difference_step)
      : problem_(problem), direction_(direction), difference_step_(difference_step), at_(guess) {}

  std::optional<double> error(int i, double /*last*/) {
    found.iterations = i + 1;
    BranchPoint& point = found.point;
    point.parameter = parameter_of(problem_, at_);
    point.state = state_of(at_);
    VectorXd image = point.state;
    found.evaluation = problem_.returns(point.parameter, image, &point.monodromy);
    if (found.evaluation != orbits::Evaluation::ok) return std::nullopt;
    defect_ = image - point.state;
    return relative_defect();
  }

  static bool converged(int i, double error, double last) {
    const bool stalled = i > 1 && error < nearly_closed && error > 0.1 * last;
    return error < closed || stalled;
  }

  bool step(int i) {
    const Eigen::Index n = defect_.size();
    if (i == 0 && !differentiate()) {
      found.evaluation = orbits::Evaluation::infeasible;
      return false;
    }
    VectorXd right(n + 1);
    right << -defect_, 0;
    const VectorXd step = numerics::dense::solve(bordered(found.point.monodromy, slope_, direction_), right);
    if (!step.allFinite()) return false;
    at_ += step;
    return true;
  }

  /// Continues a stalled iteration while its error still falls. Near a graze the derivative often belongs to
  /// other contacts, and the error then falls slowly.
  void improve() {
    constexpr int most_steps = 8;
    constexpr double nearer = 0.7;
    for (int i = 1; i <= most_steps && relative_defect() > closed; ++i) {
      Correction kept = found;
      const Position kept_at = at_;
      const VectorXd kept_defect = defect_;
      const double last = relative_defect();
      const std::optional<double> now = step(i) ? error(i, last) : std::nullopt;
      if (now && *now < nearer * last) {
        found.iterations = kept.iterations;
        continue;
      }
      found = std::move(kept);
      at_ = kept_at;
      defect_ = kept_defect;
      return;
    }
  }

  Correction found;

 private:
  double relative_defect() const { return largest(defect_) / std::max(1.0, largest(found.point.state)); }

  bool differentiate() {
    const Eigen::Index n = defect_.size();
    slope_ = VectorXd::Zero(n);
    const bool parameter_moves = direction_.head(n).cwiseAbs().maxCoeff() > 0;
    return !parameter_moves ||
           difference(problem_, found.point.state, found.point.parameter, difference_step_, slope_);
  }

  const orbits::OrbitProblem& problem_;
  const VectorXd& direction_;
  double difference_step_;
  Position at_;
  VectorXd slope_, defect_;
};

}  // namespace

Position position_of(const orbits::OrbitProblem& problem, const VectorXd& state, double parameter) {
  Position position(state.size() + 1);
  position << state / root_of_states(state.size()), parameter / problem.parameter_scale;
  return position;
}

double parameter_of(const orbits::OrbitProblem& problem, const Position& position) {
  return position(position.size() - 1) * problem.parameter_scale;
}

VectorXd state_of(const Position& position) {
  const Eigen::Index states = position.size() - 1;
  return position.head(states) * root_of_states(states);
}

Correction correct(const orbits::OrbitProblem& problem, const Position& guess, const VectorXd& direction,
                   double difference_step) {
  OrbitIteration iteration(problem, guess, direction, difference_step);
  const bool converged = numerics::newton(iteration, newton_limits);
  if (converged) iteration.improve();
  iteration.found.converged = converged;
  return std::move(iteration.found);
}

Correction correct_between(const orbits::OrbitProblem& problem, const Position& guess,
                           const BranchPoint& from, const BranchPoint& to) {
  return correct(problem, guess, from.tangent, std::min(from.difference_step, to.difference_step));
}

Correction correct_at(const orbits::OrbitProblem& problem, const VectorXd& state, double parameter) {
  VectorXd along_parameter = VectorXd::Zero(state.size() + 1);
  along_parameter(state.size()) = 1;
  return correct(problem, position_of(problem, state, parameter), along_parameter);
}

VectorXd next_step(const orbits::OrbitProblem& problem, const BranchPoint& point, const VectorXd& direction,
                   double difference_step) {
  const VectorXd unknown = VectorXd::Constant(direction.size(), std::numeric_limits<double>::quiet_NaN());
  VectorXd image = point.state, slope;
  if (problem.returns(point.parameter, image, nullptr) != orbits::Evaluation::ok ||
      !difference(problem, point.state, point.parameter, difference_step, slope))
    return unknown;
  VectorXd right(direction.size());
  right << point.state - image, 0;
  return numerics::dense::solve(bordered(point.monodromy, slope, direction), right);
}

double rounding_of_parameter(const orbits::OrbitProblem& problem, const BranchPoint& point) {
  const double rounding = next_step(problem, point, point.tangent, point.difference_step).norm();
  return std::isfinite(rounding) ? rounding * problem.parameter_scale : 0;
}

bool complete(const orbits::OrbitProblem& problem, const VectorXd& direction, BranchPoint& point) {
  VectorXd slope;
  if (!best_difference(problem, point, slope)) return false;
  VectorXd right = VectorXd::Zero(direction.size());
  right(right.size() - 1) = 1;
  VectorXd tangent = numerics::dense::solve(bordered(point.monodromy, slope, direction), right);
  if (!tangent.allFinite() || !(tangent.norm() > 0)) return false;
  tangent.normalize();
  if (tangent.dot(direction) < 0) tangent = -tangent;
  point.tangent = tangent;
  point.branching = numerics::dense::determinant(bordered(point.monodromy, slope, tangent));
  point.multipliers = orbits::multipliers_of(point.monodromy);
  point.unstable = orbits::count_outside(point.multipliers);
  return true;
}

std::optional<BranchPoint> completed(const orbits::OrbitProblem& problem, Correction found,
                                     const VectorXd& direction, double arclength) {
  BranchPoint& point = found.point;
  point.arclength = arclength;
  if (!complete(problem, direction, point)) return std::nullopt;
  if (problem.facts) {
    auto facts = problem.facts(point.parameter, point.state);
    if (!facts) return std::nullopt;
    point.facts = std::move(*facts);
  }
  return std::move(point);
}

}  // namespace rubsweep::branch::continuation
