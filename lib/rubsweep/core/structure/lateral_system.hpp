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
/// forces. The coordinates of shape j in the x and y planes are neighbours, so that equal planes give pairs.
struct LateralSystem {
  Eigen::MatrixXd mass, damping, gyroscopic, stiffness;
  std::array<Eigen::Index, 2> shapes{0, 0};  ///< m_x and m_y, numbers of shapes

  Eigen::Index coordinates() const { return shapes[0] + shapes[1]; }
  /// Index of the coordinate of shape `j` of a plane.
  Eigen::Index index(std::size_t plane, Eigen::Index j) const;
  /// Vector of all coordinates from a vector that is given per shape of one plane; zeros elsewhere.
  Eigen::VectorXd scatter(std::size_t plane, const Eigen::VectorXd& per_shape) const;
};

/// Galerkin projection, with the damping of supports and material. The identity as basis gives the full
/// model.
LateralSystem project(const BeamShaft& shaft, const PlaneBases& bases);

/// Undamped modes of one plane at rest, lowest first.
struct PlaneModes {
  Eigen::VectorXd rad_per_s;
  Eigen::MatrixXd shape;  ///< shapes as columns, mass-normalised
};

/// The `count` lowest modes of stiffness v = w^2 mass v (at least one), or fewer where fewer have mass.
/// Stiffness must be positive definite, mass at least semidefinite. Solves the inverse problem, whose largest
/// eigenvalues belong to the lowest frequencies and have full relative accuracy. Throws ConfigError when the
/// stiffness is not positive definite, or no mode can be computed.
PlaneModes plane_modes(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, Eigen::Index count);

/// A rotor kit in all coordinates of its finite elements, x and y side by side. It is the reference for the
/// reduced models: it has no reduced basis, and its structural damping includes all modes.
struct FullSystem {
  LateralSystem system;         ///< shapes are the coordinates; without the terms that depend on the speed
  Eigen::MatrixXd circulatory;  ///< circulatory matrix as in Assembly
  std::vector<TabledSupport> tables;  ///< supports with tables; `system` has their middle coefficients
};

FullSystem full_system(const BeamShaft& shaft, const model::RotorKit& kit);

/// Matrices of mass q'' + damping q' + stiffness q = forces at one speed.
struct SpeedMatrices {
  Eigen::MatrixXd mass, damping, stiffness;
};

/// The matrices at a speed. Supports with tables keep the coefficients in `full` (if `supports_rad_per_s` is
/// empty), or have those at this speed of their tables.
SpeedMatrices matrices_at(const FullSystem& full, double speed_rad_per_s,
                          std::optional<double> supports_rad_per_s = {});

}  // namespace rubsweep::structure
