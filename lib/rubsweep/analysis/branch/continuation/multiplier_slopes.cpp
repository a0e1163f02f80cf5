#include "rubsweep/analysis/branch/continuation/multiplier_slopes.hpp"

#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::continuation {

MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers) {
  return {orbits::unit_test(multipliers), orbits::doubling_test(multipliers),
          orbits::torus_test(multipliers)};
}

MultiplierTests multiplier_slopes(const orbits::OrbitProblem& problem, const BranchPoint& point) {
  constexpr double along = 1e-5;  ///< far above the noise of a turn, 1e-13, and far below any step
  const MultiplierTests here = tests_of_multipliers(point.multipliers);
  for (const double h : {along, -along}) {
    const Position at = position_of(problem, point) + h * point.tangent;
    Eigen::VectorXd state = state_of(at);
    Eigen::MatrixXd monodromy;
    if (problem.returns(parameter_of(problem, at), state, &monodromy) != orbits::Evaluation::ok) continue;
    if (!monodromy.allFinite()) continue;
    const MultiplierTests there = tests_of_multipliers(orbits::multipliers_of(monodromy));
    return {(there.unit - here.unit) / h, (there.doubling - here.doubling) / h,
            (there.torus - here.torus) / h};
  }
  return {};
}

}  // namespace rubsweep::branch::continuation
