#include "rubsweep/response/rotating/rotating_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rubsweep/numerics/eigenvalues.hpp"
#include "rubsweep/numerics/lu.hpp"
#include "rubsweep/numerics/matrix_flow.hpp"
#include "rubsweep/numerics/newton.hpp"
#include "rubsweep/response/proof/periodic_orbit.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr numerics::NewtonLimits newton_limits{.iterations = 12,
                                               .growth = std::numeric_limits<double>::infinity()};
constexpr double closed = 1e-13;  ///< Newton step, in (clearance, clearance omega)
constexpr double full_turn = 2 * std::numbers::pi;

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

/// Newton's iteration for a fixed point; see numerics::newton. Its error is the step just taken.
struct EquilibriumNewton {
  const RotatingEquations& equations;
  const VectorXd& start;
  VectorXd x = start;

  std::optional<double> error(int, double) {
    const VectorXd step = numerics::solve(equations.jacobian(x), equations.rate(x));
    x -= step;
    if (!x.allFinite() || largest(x - start) > proof::farthest_orbit) return std::nullopt;
    return largest(step);
  }
  bool converged(int, double error, double) const { return error < closed; }
  bool step(int) const { return true; }
};

}  // namespace

std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const VectorXd& start) {
  EquilibriumNewton found{.equations = equations, .start = start};
  if (!numerics::newton(found, newton_limits)) return std::nullopt;
  const MatrixXd jacobian = equations.jacobian(found.x);
  const double modulus = std::exp(full_turn * numerics::eigenvalues(jacobian).real().maxCoeff());
  if (!(modulus < proof::largest_floquet_modulus)) return std::nullopt;
  return RotatingEquilibrium{found.x, numerics::matrix_flow(jacobian, full_turn), modulus};
}

}  // namespace rubsweep::response::rotating
