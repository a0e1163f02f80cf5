#include "rubsweep/branch/curve_newton.hpp"

#include <array>
#include <cmath>

#include "rubsweep/branch/hermite.hpp"
#include "rubsweep/branch/multipliers.hpp"
#include "rubsweep/numerics/lu.hpp"

namespace rubsweep::branch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int newton_iterations = 12;
constexpr double closed = 1e-13;  ///< last correction, per unit of the position's size
/// Where rounding lets no better: of the parameters the same, of all coordinates this.
constexpr double nearly_closed = 1e-11, nearly_closed_state = 1e-6;
/// Steps of differences: those of extend(), then finer ones for orbits so near to a graze that the usual ones
/// lead over it.
constexpr std::array steps_of_differences{1.0, 0.01};
constexpr double least_condition = 1e-15;

MatrixXd bordered(const Extended& extended, const Position& direction) {
  MatrixXd matrix(direction.size(), direction.size());
  matrix << extended.jacobian, direction.transpose();
  return matrix;
}

CurveCorrection correct_with(const ExtendedSystem& system, const Position& guess, const Position& direction,
                             double difference_steps) {
  CurveCorrection found;
  found.at = guess;
  double last = 0;
  for (int i = 0; i < newton_iterations; ++i) {
    found.iterations = i + 1;
    found.extended = extend(system, found.at, difference_steps);
    found.evaluation = found.extended.evaluation;
    if (found.evaluation != Evaluation::ok) return found;
    const numerics::LuFactors lu(bordered(found.extended, direction));
    if (!(lu.reciprocal_condition() > least_condition)) {
      found.singular = true;
      return found;
    }
    VectorXd right(guess.size());
    right << -found.extended.residual, 0;
    const VectorXd step = lu.solve(right);
    const double size = step.norm() / (1 + found.at.norm());
    if (!std::isfinite(size)) return found;
    found.error = step.tail(2).cwiseAbs().maxCoeff();
    const bool stalled =
        i > 1 && found.error < nearly_closed && size < nearly_closed_state && size > 0.1 * last;
    if (size < closed || stalled) {
      found.converged = true;
      return found;
    }
    if (i > 3 && size > last) return found;
    last = size;
    found.at += step;
  }
  return found;
}

}  // namespace

CurveCorrection correct(const ExtendedSystem& system, const Position& guess, const Position& direction) {
  CurveCorrection found;
  for (const double steps : steps_of_differences) {
    found = correct_with(system, guess, direction, steps);
    if (found.converged || found.evaluation != Evaluation::ok) break;
  }
  return found;
}

std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const Position& direction, double arclength) {
  const numerics::LuFactors lu(bordered(found.extended, direction));
  VectorXd along = VectorXd::Zero(direction.size());
  along(along.size() - 1) = 1;
  CurvePoint point;
  point.tangent = lu.solve(along);
  if (!(lu.reciprocal_condition() > least_condition) || !point.tangent.allFinite()) return std::nullopt;
  point.tangent.normalize();
  point.at = found.at;
  point.place = place_of(system, found.at);
  point.state = state_of(system, found.at);
  point.arclength = arclength;
  point.error = found.error;
  point.critical = found.extended.critical;
  point.multipliers = multipliers_of(found.extended.monodromy);
  if (!system.orbits->facts) return point;
  auto facts = system.orbits->facts(point.place, point.state);
  if (!facts) return std::nullopt;
  point.facts = std::move(*facts);
  return point;
}

CurveSegment::CurveSegment(const ExtendedSystem& system, const CurvePoint& from, const CurvePoint& to)
    : system_(system), from_(from), to_(to), length_(from.tangent.dot(to.at - from.at)) {}

std::optional<CurvePoint> CurveSegment::at(double s) const {
  if (s <= 0) return from_;
  if (s >= length_) return to_;
  const Position guess = hermite_guess({from_.at, from_.tangent}, {to_.at, to_.tangent}, length_, s);
  const CurveCorrection found = correct(system_, guess, from_.tangent);
  if (!found.converged) return std::nullopt;
  return completed(system_, found, from_.tangent,
                   from_.arclength + s / length_ * (to_.arclength - from_.arclength));
}

}  // namespace rubsweep::branch
