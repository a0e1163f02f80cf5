#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// Shapes (columns) that span the motion of each plane, n x m_x and n x m_y.
using PlaneBases = std::array<Eigen::MatrixXd, 2>;

/// A beam shaft in the coordinates of its shapes: mass q'' + (damping + speed gyroscopic) q' + stiffness q =
/// forces. The coordinates of shape j in the x and the y plane stand side by side, so that equal planes make
/// pairs.
struct LateralSystem {
  Eigen::MatrixXd mass, damping, gyroscopic, stiffness;
  std::array<Eigen::Index, 2> shapes{0, 0};  ///< m_x, m_y

  Eigen::Index coordinates() const { return shapes[0] + shapes[1]; }
  /// Index of the coordinate of shape `j` of a plane.
  Eigen::Index index(std::size_t plane, Eigen::Index j) const;
  /// A vector in one plane, given per shape, among all coordinates.
  Eigen::VectorXd scatter(std::size_t plane, const Eigen::VectorXd& per_shape) const;
};

/// Galerkin projection, with the damping of supports and material. The identity as basis gives the full
/// model.
LateralSystem project(const BeamShaft& shaft, const PlaneBases& bases);

/// Undamped modes of one plane at rest, lowest first.
struct PlaneModes {
  Eigen::VectorXd rad_per_s;
  Eigen::MatrixXd shape;  ///< columns, mass-normalised
};

/// Modes of stiffness v = w^2 mass v; stiffness positive definite, mass at least semidefinite. The `count`
/// lowest ones, fewer where fewer have mass. Works on the inverse problem, whose largest values are the
/// lowest frequencies: these are the ones that come out with full relative accuracy. At least one. Throws
/// ConfigError when the stiffness is not positive definite, or no mode can be computed.
PlaneModes plane_modes(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, Eigen::Index count);

/// A rotor kit in all coordinates of its finite elements, x and y side by side: what its reduced models are
/// judged by. Nothing of it comes from a reduced basis: structural damping is that of all modes.
struct FullSystem {
  LateralSystem system;         ///< shapes are the coordinates themselves; without what depends on the speed
  Eigen::MatrixXd circulatory;  ///< matrix as of Assembly
  std::vector<TabledSupport> tables;  ///< supports that follow the speed; `system` holds their middle one
};

FullSystem full_system(const BeamShaft& shaft, const model::RotorKit& kit);

/// mass q'' + damping q' + stiffness q = forces at one speed.
struct SpeedMatrices {
  Eigen::MatrixXd mass, damping, stiffness;
};

/// The matrices at a speed; supports by tables as the matrices hold them (`supports_rad_per_s` empty) or at a
/// speed of their tables.
SpeedMatrices matrices_at(const FullSystem& full, double speed_rad_per_s,
                          std::optional<double> supports_rad_per_s = {});

}  // namespace rubsweep::structure
