#include "rubsweep/core/structure/lateral_system.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/cholesky.hpp"
#include "rubsweep/core/numerics/dense/self_adjoint.hpp"

namespace rubsweep::structure {
namespace {

constexpr const char* no_modes =
    "rotor: its masses and stiffnesses are too far apart to have modes that can be computed, allowed: less "
    "extreme "
    "numbers";

/// Adds the projected block of planes (a, b) where its shapes stand.
void add(const LateralSystem& system, std::size_t a, std::size_t b, const Eigen::MatrixXd& block,
         Eigen::MatrixXd& matrix) {
  for (Eigen::Index i = 0; i < block.rows(); ++i) {
    for (Eigen::Index j = 0; j < block.cols(); ++j) {
      matrix(system.index(a, i), system.index(b, j)) += block(i, j);
    }
  }
}

bool equal_planes(const BeamShaft& shaft, const PlaneBases& bases) {
  return bases[0].cols() == bases[1].cols() && bases[0] == bases[1] &&
         shaft.added_mass[0] == shaft.added_mass[1] &&
         shaft.support_stiffness[0][0] == shaft.support_stiffness[1][1] &&
         shaft.support_damping[0][0] == shaft.support_damping[1][1];
}

}  // namespace

Eigen::Index LateralSystem::index(std::size_t plane, Eigen::Index j) const {
  const Eigen::Index pairs = std::min(shapes[0], shapes[1]);
  return j < pairs ? 2 * j + static_cast<Eigen::Index>(plane) : pairs + j;
}

Eigen::VectorXd LateralSystem::scatter(std::size_t plane, const Eigen::VectorXd& per_shape) const {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(coordinates());
  for (Eigen::Index j = 0; j < per_shape.size(); ++j) vector(index(plane, j)) = per_shape(j);
  return vector;
}

LateralSystem project(const BeamShaft& shaft, const PlaneBases& bases) {
  LateralSystem system;
  system.shapes = {bases[0].cols(), bases[1].cols()};
  const Eigen::Index n = system.coordinates();
  system.mass = system.damping = system.gyroscopic = system.stiffness = Eigen::MatrixXd::Zero(n, n);
  const auto between = [&](std::size_t a, std::size_t b, const Eigen::MatrixXd& full) {
    return Eigen::MatrixXd(bases[a].transpose() * full * bases[b]);
  };
  for (std::size_t a = 0; a < 2; ++a) {
    // Equal planes get the same bits: a symmetry of the machine is not lost to rounding.
    const std::size_t from = equal_planes(shaft, bases) ? 0 : a;
    add(system, a, a, between(from, from, shaft.plane_mass(from)), system.mass);
    add(system, a, a, between(from, from, shaft.plane_stiffness(from)), system.stiffness);
    add(system, a, a, between(from, from, shaft.damping + shaft.support_damping[from][from]), system.damping);
    const std::size_t b = 1 - a;
    if (!shaft.support_stiffness[a][b].isZero(0)) {
      add(system, a, b, between(a, b, shaft.support_stiffness[a][b]), system.stiffness);
    }
    if (!shaft.support_damping[a][b].isZero(0)) {
      add(system, a, b, between(a, b, shaft.support_damping[a][b]), system.damping);
    }
  }
  Eigen::MatrixXd turning = between(0, 1, shaft.gyroscopic);
  if (equal_planes(shaft, bases)) turning = (turning + turning.transpose().eval()) / 2;
  add(system, 0, 1, turning, system.gyroscopic);
  add(system, 1, 0, -turning.transpose(), system.gyroscopic);
  return system;
}

PlaneModes plane_modes(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, Eigen::Index count) {
  constexpr double massless = 1e-14;  // of the largest 1/w^2
  if (!mass.allFinite() || !stiffness.allFinite()) {
    throw ConfigError(
        "rotor: its numbers give a mass or stiffness that is no finite number, allowed: less extreme ones");
  }
  const numerics::dense::CholeskyFactors factor(stiffness);
  if (!factor.positive_definite()) {
    throw ConfigError(
        "rotor.supports: they leave the shaft free to move as a whole, or are so much stiffer or softer than "
        "the "
        "shaft that rounding says so, allowed: supports that hold it");
  }
  const Eigen::MatrixXd half = factor.solve_lower(mass);
  Eigen::MatrixXd inverse = factor.solve_lower(half.transpose());
  inverse = (inverse + inverse.transpose().eval()) / 2;
  const auto all = numerics::dense::self_adjoint_modes(inverse);
  const Eigen::VectorXd& values = all.values;
  const Eigen::Index n = values.size();
  Eigen::Index kept = 0;
  if (!all.converged) throw ConfigError(no_modes);
  while (kept < std::min(count, n) && values(n - 1 - kept) > massless * values(n - 1)) ++kept;
  if (kept == 0) throw ConfigError(no_modes);
  PlaneModes modes{Eigen::VectorXd(kept), Eigen::MatrixXd(n, kept)};
  for (Eigen::Index j = 0; j < kept; ++j) {
    const double value = values(n - 1 - j);
    modes.rad_per_s(j) = 1 / std::sqrt(value);
    modes.shape.col(j) = factor.solve_upper(all.vectors.col(n - 1 - j)) / std::sqrt(value);
  }
  if (!modes.rad_per_s.allFinite() || !modes.shape.allFinite()) throw ConfigError(no_modes);
  return modes;
}

}  // namespace rubsweep::structure
