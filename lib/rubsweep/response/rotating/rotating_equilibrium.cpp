#include "rubsweep/response/rotating/rotating_equilibrium.hpp"

#include <cmath>
#include <limits>

#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/numerics/dense/lu.hpp"
#include "rubsweep/numerics/full_turn.hpp"
#include "rubsweep/numerics/matrix_flow.hpp"
#include "rubsweep/numerics/newton.hpp"
#include "rubsweep/response/proof/periodic_orbit.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits equilibrium_newton{.iterations = 12,
                                                    .growth = std::numeric_limits<double>::infinity()};
constexpr double closed = 1e-13;  ///< Newton step, in (clearance, clearance omega)

/// Newton's iteration for a fixed point; see numerics::newton. Its error is the step just taken.
struct EquilibriumNewton {
  const RotatingEquations& equations;
  const VectorXd& start;
  VectorXd x = start;

  std::optional<double> error(int, double) {
    const VectorXd step = numerics::dense::solve(equations.jacobian(x), equations.rate(x));
    x -= step;
    if (!x.allFinite() || (x - start).cwiseAbs().maxCoeff() > proof::farthest_orbit) return std::nullopt;
    return step.cwiseAbs().maxCoeff();
  }
  bool converged(int, double error, double) const { return error < closed; }
  bool step(int) const { return true; }
};

}  // namespace

std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const VectorXd& start) {
  EquilibriumNewton found{.equations = equations, .start = start};
  if (!numerics::newton(found, equilibrium_newton)) return std::nullopt;
  const MatrixXd jacobian = equations.jacobian(found.x);
  const double modulus =
      std::exp(numerics::full_turn * numerics::dense::eigenvalues(jacobian).real().maxCoeff());
  if (!(modulus < proof::largest_floquet_modulus)) return std::nullopt;
  return RotatingEquilibrium{found.x, numerics::matrix_flow(jacobian, numerics::full_turn), modulus};
}

}  // namespace rubsweep::response::rotating
