#include "rubsweep/response/rotating/rotating_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/numerics/eigenvalues.hpp"
#include "rubsweep/numerics/lu.hpp"
#include "rubsweep/numerics/matrix_flow.hpp"
#include "rubsweep/response/proof/periodic_orbit.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int newton_iterations = 12;
constexpr double closed = 1e-13;  ///< Newton step, in (clearance, clearance omega)
constexpr double full_turn = 2 * std::numbers::pi;

double largest(const VectorXd& x) { return x.cwiseAbs().maxCoeff(); }

std::optional<VectorXd> fixed_point(const RotatingEquations& equations, const VectorXd& start) {
  VectorXd x = start;
  for (int i = 0; i < newton_iterations; ++i) {
    const VectorXd step = numerics::solve(equations.jacobian(x), equations.rate(x));
    x -= step;
    if (!x.allFinite() || largest(x - start) > proof::farthest_orbit) return std::nullopt;
    if (largest(step) < closed) return x;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const VectorXd& start) {
  const auto point = fixed_point(equations, start);
  if (!point) return std::nullopt;
  const MatrixXd jacobian = equations.jacobian(*point);
  const double modulus = std::exp(full_turn * numerics::eigenvalues(jacobian).real().maxCoeff());
  if (!(modulus < proof::largest_floquet_modulus)) return std::nullopt;
  return RotatingEquilibrium{*point, numerics::matrix_flow(jacobian, full_turn), modulus};
}

}  // namespace rubsweep::response::rotating
