#include "rubsweep/analysis/branch/curves/curve.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/branch/orbits/multipliers.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/newton.hpp"

namespace rubsweep::branch::curves {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits newton_limits{.iterations = 12, .free_iterations = 4, .growth = 1};
constexpr double closed = 1e-13;  ///< last correction, relative to the size of the position
/// Tolerances where rounding permits no smaller error: for the parameters, and for all coordinates.
constexpr double nearly_closed = 1e-11, nearly_closed_state = 1e-6;
/// Steps of differences, as shares of the usual ones in extend(). The smaller share is for orbits so close to
/// a graze that the usual steps would cross the graze.
constexpr std::array steps_of_differences{1.0, 0.01};
constexpr double least_condition = 1e-15;

MatrixXd bordered(const Extended& extended, const continuation::Position& direction) {
  MatrixXd matrix(direction.size(), direction.size());
  matrix << extended.jacobian, direction.transpose();
  return matrix;
}

/// Newton's iteration on the extended system; the unknown is the position.
class CurveIteration {
 public:
  CurveIteration(const ExtendedSystem& system, const continuation::Position& guess,
                 const continuation::Position& direction, double difference_steps)
      : system_(system), direction_(direction), difference_steps_(difference_steps) {
    found.at = guess;
  }

  /// Size of the next step.
  std::optional<double> error(int i, double /*last*/) {
    found.iterations = i + 1;
    found.extended = extend(system_, found.at, difference_steps_);
    found.evaluation = found.extended.evaluation;
    if (found.evaluation != orbits::Evaluation::ok) return std::nullopt;
    const numerics::dense::LuFactors lu(bordered(found.extended, direction_));
    if (!(lu.reciprocal_condition() > least_condition)) {
      found.singular = true;
      return std::nullopt;
    }
    VectorXd right(found.at.size());
    right << -found.extended.residual, 0;
    step_ = lu.solve(right);
    found.error = step_.tail(2).cwiseAbs().maxCoeff();
    return step_.norm() / (1 + found.at.norm());
  }

  bool converged(int i, double size, double last) const {
    const bool stalled =
        i > 1 && found.error < nearly_closed && size < nearly_closed_state && size > 0.1 * last;
    return size < closed || stalled;
  }

  bool step(int /*i*/) {
    found.at += step_;
    return true;
  }

  CurveCorrection found;

 private:
  const ExtendedSystem& system_;
  const continuation::Position& direction_;
  double difference_steps_;
  VectorXd step_;
};

CurveCorrection correct_with(const ExtendedSystem& system, const continuation::Position& guess,
                             const continuation::Position& direction, double difference_steps) {
  CurveIteration iteration(system, guess, direction, difference_steps);
  const bool converged = numerics::newton(iteration, newton_limits);
  iteration.found.converged = converged;
  return std::move(iteration.found);
}

}  // namespace

CurveCorrection correct(const ExtendedSystem& system, const continuation::Position& guess,
                        const continuation::Position& direction) {
  CurveCorrection found;
  for (const double steps : steps_of_differences) {
    found = correct_with(system, guess, direction, steps);
    if (found.converged || found.evaluation != orbits::Evaluation::ok) break;
  }
  return found;
}

std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const continuation::Position& direction, double arclength) {
  const numerics::dense::LuFactors lu(bordered(found.extended, direction));
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
  point.multipliers = orbits::multipliers_of(found.extended.monodromy);
  if (!system.orbits->facts) return point;
  auto facts = system.orbits->facts(point.place, point.state);
  if (!facts) return std::nullopt;
  point.facts = std::move(*facts);
  return point;
}

continuation::Position nearest_image(const ExtendedSystem& system, continuation::Position position,
                                     const CurvePoint& near) {
  constexpr double turn = 2 * std::numbers::pi;
  if (system.has_phase())
    position(system.states) += turn * std::round((near.at(system.states) - position(system.states)) / turn);
  return position;
}

CurvePoint turned_about(CurvePoint point) {
  point.tangent = -point.tangent;
  return point;
}

}  // namespace rubsweep::branch::curves
