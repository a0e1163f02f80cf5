#include "rubsweep/core/structure/lateral_system.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {
namespace {

constexpr const char* no_modes =
    "rotor: its masses and stiffnesses are too far apart to have modes that can be computed, allowed: less "
    "extreme "
    "numbers";

/// Adds the projected block of planes (a, b) at the indices of its shapes.
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

using Eigen::Index;

/// Damping matrix, the sum of 2 ratio w (m shape) (m shape)^T over all modes of a plane.
Eigen::MatrixXd by_modes(const BeamShaft& shaft, std::size_t plane, const std::vector<double>& ratios) {
  const Index n = shaft.coordinates();
  if (std::ranges::all_of(ratios, [](double ratio) { return ratio == 0; }))
    return Eigen::MatrixXd::Zero(n, n);
  const PlaneModes modes = plane_modes(shaft.plane_mass(plane), shaft.plane_stiffness(plane), n);
  Eigen::VectorXd rates = 2 * modes.rad_per_s;
  for (Index j = 0; j < rates.size(); ++j)
    rates(j) *= ratios[std::min(static_cast<std::size_t>(j), ratios.size() - 1)];
  const Eigen::MatrixXd momentum = shaft.plane_mass(plane) * modes.shape;
  return momentum * rates.asDiagonal() * momentum.transpose();
}

/// View of the block of a matrix with rows of plane a and columns of plane b.
auto block(Eigen::MatrixXd& matrix, Index a, Index b) {
  const Index n = matrix.rows() / 2;
  return matrix(Eigen::seqN(a, n, 2), Eigen::seqN(b, n, 2));
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
    // Equal planes get bitwise equal matrices, so that rounding does not break the symmetry of the machine.
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
  constexpr double massless = 1e-14;  // share of the largest 1/w^2: smaller ones have no mass
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

FullSystem full_system(const BeamShaft& shaft, const model::RotorKit& kit) {
  const Index n = shaft.coordinates();
  FullSystem full;
  LateralSystem& system = full.system;
  system.shapes = {n, n};
  system.mass = system.damping = system.gyroscopic = system.stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Index a = 0; a < 2; ++a) {
    const auto plane = static_cast<std::size_t>(a), other = 1 - plane;
    block(system.mass, a, a) = shaft.plane_mass(plane);
    block(system.stiffness, a, a) = shaft.plane_stiffness(plane);
    block(system.damping, a, a) =
        shaft.damping + shaft.support_damping[plane][plane] + by_modes(shaft, plane, kit.damping_ratio);
    block(system.stiffness, a, 1 - a) = shaft.support_stiffness[plane][other];
    block(system.damping, a, 1 - a) = shaft.support_damping[plane][other];
  }
  block(system.gyroscopic, 0, 1) = shaft.gyroscopic;
  block(system.gyroscopic, 1, 0) = -shaft.gyroscopic.transpose();
  if (model::has_rotating_damping(kit)) {
    const Eigen::MatrixXd line = by_modes(shaft, 0, kit.rotating_damping_ratio);
    full.circulatory = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (Index a = 0; a < 2; ++a) block(system.damping, a, a) += line;
    block(full.circulatory, 0, 1) = line;
    block(full.circulatory, 1, 0) = -line;
  }
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  full.tables = tabled_supports(shaft, kit, {one, one}, system, 2 * n);
  return full;
}

SpeedMatrices matrices_at(const FullSystem& full, double speed_rad_per_s,
                          std::optional<double> supports_rad_per_s) {
  SpeedMatrices at{full.system.mass, full.system.damping + speed_rad_per_s * full.system.gyroscopic,
                   full.system.stiffness};
  if (full.circulatory.size() > 0) at.stiffness += speed_rad_per_s * full.circulatory;
  if (supports_rad_per_s) {
    for (const TabledSupport& support : full.tables)
      add_lacking(support, *supports_rad_per_s, at.mass, at.damping, at.stiffness);
  }
  return at;
}

}  // namespace rubsweep::structure
