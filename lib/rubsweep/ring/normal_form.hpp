#pragma once

#include <Eigen/Core>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

/// Y'' + O S1 Y' + (S0 - O^2 S2) Y = 0: coordinates scaled by the mass diagonal and multiplied by M^-1, time
/// in units of 1 / reference, O = Omega / reference. All entries are then of the order of one.
struct NormalForm {
  Eigen::MatrixXd rotation;   ///< S1
  Eigen::MatrixXd stiffness;  ///< S0
  Eigen::MatrixXd softening;  ///< S2
  double reference_rad_per_s = 1;
  bool has_friction = false;

  Eigen::Index coordinates() const { return stiffness.rows(); }
};

/// Throws ConfigError when the mass matrix is singular: a load without mass that may move, or a friction
/// coefficient at which the rubbing force cancels the inertia.
NormalForm normal_form(const System& system);

/// First-order form: d/dt (Y, Y') = state_matrix (Y, Y') in scaled time.
Eigen::MatrixXd state_matrix(const NormalForm& form, double speed_rad_per_s);

/// Its derivative by O.
Eigen::MatrixXd state_matrix_slope(const NormalForm& form, double speed_rad_per_s);

}  // namespace rubsweep::ring
