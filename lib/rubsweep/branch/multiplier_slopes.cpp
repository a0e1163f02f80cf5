#include "rubsweep/branch/multiplier_slopes.hpp"

#include "rubsweep/branch/multipliers.hpp"
#include "rubsweep/branch/orbit_newton.hpp"

namespace rubsweep::branch {

MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers) {
  return {unit_test(multipliers), doubling_test(multipliers), torus_test(multipliers)};
}

MultiplierTests multiplier_slopes(const OrbitProblem& problem, const BranchPoint& point) {
  constexpr double along = 1e-5;  ///< far above the noise of a turn, 1e-13, and far below any step
  const MultiplierTests here = tests_of_multipliers(point.multipliers);
  for (const double h : {along, -along}) {
    const Position at = position_of(problem, point) + h * point.tangent;
    Eigen::VectorXd state = state_of(at);
    Eigen::MatrixXd monodromy;
    if (problem.returns(parameter_of(problem, at), state, &monodromy) != Evaluation::ok) continue;
    if (!monodromy.allFinite()) continue;
    const MultiplierTests there = tests_of_multipliers(multipliers_of(monodromy));
    return {(there.unit - here.unit) / h, (there.doubling - here.doubling) / h,
            (there.torus - here.torus) / h};
  }
  return {};
}

}  // namespace rubsweep::branch
