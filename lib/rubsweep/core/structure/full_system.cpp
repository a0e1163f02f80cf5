#include "rubsweep/core/structure/full_system.hpp"

#include <algorithm>

#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;

/// Operator 2 ratio w (m shape) (m shape)^T over all modes of a plane: a force by the velocity along it.
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

/// The block of a matrix in the coordinates of planes a (rows) and b.
auto block(Eigen::MatrixXd& matrix, Index a, Index b) {
  const Index n = matrix.rows() / 2;
  return matrix(Eigen::seqN(a, n, 2), Eigen::seqN(b, n, 2));
}

}  // namespace

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
