#include "rubsweep/analysis/branch/continuation/doubling.hpp"

#include <utility>

#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/core/numerics/spectral/singular_values.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// Unit vector that the monodromy matrix maps to its opposite.
Eigen::VectorXd alternating(const Eigen::MatrixXd& monodromy) {
  const Eigen::Index n = monodromy.rows();
  const Eigen::MatrixXd sum = monodromy + Eigen::MatrixXd::Identity(n, n);
  return numerics::spectral::singular_values(sum).v.col(n - 1);
}

}  // namespace

std::optional<BranchPoint> doubled_start(const orbits::OrbitProblem& doubled, const BranchPoint& doubling) {
  const Position here = position_of(doubled, doubling);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(here.size());
  direction.head(here.size() - 1) = alternating(doubling.monodromy);
  for (const double distance : {1e-4, 1e-5, 3e-4, 1e-3}) {
    const Correction found = correct(doubled, here + distance * direction, direction);
    if (!found.converged) continue;
    if ((position_of(doubled, found.point) - here).norm() > 3 * distance) continue;
    auto start = completed(doubled, found, direction, 0);
    if (start) return start;
  }
  return std::nullopt;
}

}  // namespace rubsweep::branch::continuation
