#include "rubsweep/structure/stability.hpp"

#include <cmath>
#include <numbers>

#include "rubsweep/numerics/dense/cholesky.hpp"
#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/structure/system_at.hpp"

namespace rubsweep::structure {
namespace {

constexpr int grid_speeds = 200;
constexpr double rounding = 1e-9;  ///< of the fastest rate
constexpr int bisections = 30;

Eigen::VectorXcd rates_per_s(const Eigen::MatrixXd& inertia, const Eigen::MatrixXd& damping,
                             const Eigen::MatrixXd& stiffness) {
  const numerics::dense::SymmetricFactors mass(inertia);
  const Eigen::Index n = inertia.rows();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n).setIdentity();
  generator.bottomLeftCorner(n, n) = -mass.solve(stiffness);
  generator.bottomRightCorner(n, n) = -mass.solve(damping);
  // Power of two beyond which the time unit is changed so that displacements and velocities are alike:
  // otherwise small eigenvalues would be lost in the rounding of large ones. It costs no rounding.
  constexpr int far_from_the_unit = 20;
  const double largest = generator.bottomLeftCorner(n, n).cwiseAbs().maxCoeff();
  const int order = largest > 0 ? std::ilogb(std::sqrt(largest)) : 0;
  if (std::abs(order) > far_from_the_unit) {
    generator.topRightCorner(n, n) *= std::ldexp(1.0, order);
    generator.bottomLeftCorner(n, n) *= std::ldexp(1.0, -order);
  }
  // NaN where they are unknown: no vibration is reported to grow.
  return numerics::dense::eigenvalues(generator);
}

Eigen::VectorXcd rates_per_s(const Assembly& assembly, double speed_rad_per_s) {
  const LinearSystem system = system_at(assembly, speed_rad_per_s);
  return rates_per_s(system.mass, system.damping, system.stiffness);
}

bool any_grows(const Eigen::VectorXcd& rates) {
  return rates.real().maxCoeff() > rounding * rates.cwiseAbs().maxCoeff();
}

}  // namespace

double growth_per_s(const Assembly& assembly, double speed_rad_per_s) {
  return rates_per_s(assembly, speed_rad_per_s).real().maxCoeff();
}

bool grows(const Assembly& assembly, double speed_rad_per_s) {
  return any_grows(rates_per_s(assembly, speed_rad_per_s));
}

bool grows(const LinearSystem& system) {
  return any_grows(rates_per_s(system.mass, system.damping, system.stiffness));
}

std::optional<double> instability_hz(const Assembly& assembly, double highest_hz) {
  const auto grows_at = [&](double hz) { return grows(assembly, 2 * std::numbers::pi * hz); };
  if (grows_at(0)) return 0;
  const auto on_grid = [&](int k) { return highest_hz * k / grid_speeds; };
  for (int k = 1; k <= grid_speeds; ++k) {
    double above = on_grid(k);
    if (!grows_at(above)) continue;
    double below = on_grid(k - 1);
    for (int i = 0; i < bisections; ++i) {
      const double middle = (below + above) / 2;
      (grows_at(middle) ? above : below) = middle;
    }
    return above;
  }
  return std::nullopt;
}

}  // namespace rubsweep::structure
