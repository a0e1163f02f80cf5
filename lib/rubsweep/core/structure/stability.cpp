#include "rubsweep/core/structure/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::structure {
namespace {

constexpr int grid_speeds = 200;
constexpr int bisections = 30;
/// Relative error in the symmetry of a matrix after its projection on shapes.
constexpr double rounding_of_a_projection = 1e-10;

/// State matrix for states (w p, p') of mass-normalised coordinates p, where w is the frequency of each
/// coordinate alone. All entries are rates, so that slow vibrations are as accurate as fast ones.
Eigen::MatrixXd generator_of(const LinearSystem& system) {
  const numerics::dense::CholeskyFactors mass(system.mass);
  const auto normalised = [&](const Eigen::MatrixXd& matrix) {
    const Eigen::MatrixXd half = mass.solve_lower(matrix);
    return Eigen::MatrixXd(mass.solve_lower(half.transpose()).transpose());
  };
  const Eigen::MatrixXd stiffness = normalised(system.stiffness);
  const double fastest = stiffness.diagonal().cwiseAbs().maxCoeff();
  // Lower bound of the rate of a coordinate with almost no stiffness.
  const Eigen::VectorXd rate =
      stiffness.diagonal().cwiseAbs().cwiseMax(fastest > 0 ? 1e-16 * fastest : 1).cwiseSqrt();
  const Eigen::Index n = rate.size();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = rate.asDiagonal();
  generator.bottomLeftCorner(n, n) = -stiffness * rate.cwiseInverse().asDiagonal();
  generator.bottomRightCorner(n, n) = -normalised(system.damping);
  return generator;
}

bool never_grows(const LinearSystem& system) {
  return structure::dissipates(system.mass, system.damping, system.stiffness, rounding_of_a_projection);
}

}  // namespace

bool dissipates(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping, const Eigen::MatrixXd& stiffness,
                double rounding) {
  const Eigen::VectorXd size = stiffness.diagonal().cwiseAbs().cwiseSqrt();
  const Eigen::MatrixXd skew = (stiffness - stiffness.transpose()) / 2;
  if (!(skew.cwiseAbs().array() <= rounding * (size * size.transpose()).array()).all()) return false;
  const auto definite = [](const Eigen::MatrixXd& matrix) {
    const Eigen::VectorXd unit = matrix.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    return unit.allFinite() &&
           numerics::dense::CholeskyFactors(unit.asDiagonal() * matrix * unit.asDiagonal())
               .positive_definite();
  };
  if (!definite((stiffness + stiffness.transpose()) / 2)) return false;
  Eigen::MatrixXd lossy = (damping + damping.transpose()) / 2;
  if (lossy.isZero(0)) return true;
  const Eigen::VectorXd hardly = size.cwiseProduct(mass.diagonal().cwiseAbs().cwiseSqrt());
  lossy.diagonal() += std::max(rounding, 1e-12) * hardly.cwiseMax(1e-12 * hardly.maxCoeff());
  return definite(lossy);
}

double growth_per_s(const LinearSystem& system) {
  const Eigen::MatrixXd generator = generator_of(system);
  const auto modes = numerics::dense::eigenvectors(generator);
  if (!modes.values.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const double largest = modes.values.real().maxCoeff();
  if (!(largest > 0)) return largest;
  if (never_grows(system)) return 0;
  // The condition number of a rate's eigenvector shows how far rounding shifts the rate.
  constexpr double steps = 8;
  const Eigen::MatrixXcd left = numerics::dense::inverse(modes.vectors);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double growth = 0;
  for (Eigen::Index k = 0; k < modes.values.size(); ++k) {
    // A defective eigenvector has no condition number; rounding then shifts its rate by sqrt(epsilon).
    const double condition = left.row(k).norm() * modes.vectors.col(k).norm();
    const double share =
        std::isfinite(condition) ? std::min(epsilon * condition, std::sqrt(epsilon)) : std::sqrt(epsilon);
    const double rate = modes.values(k).real();
    if (rate > steps * share * generator.norm()) growth = std::max(growth, rate);
  }
  return growth;
}

double growth_per_s(const Assembly& assembly, double speed_rad_per_s) {
  return growth_per_s(system_at(assembly, speed_rad_per_s));
}

// Rates that cannot be computed are NaN: then no vibration is reported to grow.
bool grows(const Assembly& assembly, double speed_rad_per_s) {
  return grows(system_at(assembly, speed_rad_per_s));
}

bool grows(const LinearSystem& system) { return !never_grows(system) && growth_per_s(system) > 0; }

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
