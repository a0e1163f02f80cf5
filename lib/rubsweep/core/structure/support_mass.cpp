#include "rubsweep/core/structure/support_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

double least_mass_kg(const model::Support& support) { return std::min(support.mass_x_kg, support.mass_y_kg); }

/// Whether a symmetric matrix is positive definite in the coordinates that have a row.
bool has_no_negative_mass(const MatrixXd& mass) {
  std::vector<Index> heavy;
  for (Index i = 0; i < mass.rows(); ++i)
    if (!mass.row(i).isZero(0)) heavy.push_back(i);
  if (heavy.empty()) return true;
  const MatrixXd part = mass(heavy, heavy);
  if (!(part.diagonal().minCoeff() > 0)) return false;
  const Eigen::VectorXd unit = part.diagonal().cwiseSqrt().cwiseInverse();
  return numerics::dense::CholeskyFactors(unit.asDiagonal() * part * unit.asDiagonal()).positive_definite();
}

/// Refuses a mode of this frequency in the range that matters: up to ten times the first if modes are given.
void refuse_slow_mode(const model::RotorKit& kit, double hz, double first_hz) {
  const double up_to_hz = kit.modes ? std::min(10 * first_hz, kit.modes_up_to_hz) : kit.modes_up_to_hz;
  if (hz >= up_to_hz) return;
  const auto lightest = std::ranges::min_element(kit.supports, {}, least_mass_kg) - kit.supports.begin();
  throw ConfigError(fmt::format(
      "{}: its fluid takes all mass of a mode of {:.4g} Hz, and modes up to {:.4g} Hz are needed, allowed: "
      "masses nearer to 0, or a smaller rotor.modes_up_to_hz",
      model::support_path(kit, static_cast<std::size_t>(lightest)), hz, up_to_hz));
}

/// Mass that is to be added to one plane. Zero where the stiffness does not hold all coordinates, which is an
/// error that is reported later.
MatrixXd lacking(const model::RotorKit& kit, const MatrixXd& mass, const MatrixXd& stiffness) {
  constexpr double massless = 1e-14;  // share of the largest 1/w^2: smaller ones have no mass
  MatrixXd added = MatrixXd::Zero(mass.rows(), mass.cols());
  const numerics::dense::CholeskyFactors factor(stiffness);
  if (has_no_negative_mass(mass) || !factor.positive_definite()) return added;
  const MatrixXd half = factor.solve_lower(mass), inverse = factor.solve_lower(half.transpose());
  const auto modes = numerics::dense::self_adjoint_modes(MatrixXd((inverse + inverse.transpose()) / 2));
  if (!modes.converged) return added;
  const Index n = modes.values.size();
  const auto hz = [&](Index k) { return 1 / (2 * std::numbers::pi * std::sqrt(std::abs(modes.values(k)))); };
  for (Index k = 0; k < n && modes.values(k) < -massless * modes.values(n - 1); ++k) {
    refuse_slow_mode(kit, hz(k), hz(n - 1));
    const Eigen::VectorXd force = factor.upper().transpose() * modes.vectors.col(k);  // K v
    added -= 2 * modes.values(k) * force * force.transpose();
  }
  return added;
}

}  // namespace

void keep_mass_positive(const model::RotorKit& kit, BeamShaft& shaft) {
  const auto takes_mass = [](const model::Support& support) { return least_mass_kg(support) < 0; };
  if (std::ranges::none_of(kit.supports, takes_mass)) return;
  for (std::size_t a = 0; a < 2; ++a)
    shaft.added_mass[a] += lacking(kit, shaft.plane_mass(a), shaft.plane_stiffness(a));
}

}  // namespace rubsweep::structure
