#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::fit {

/// Vibration modes of a machine without its contacts at one shaft speed: the state (q, q') is vectors * a,
/// with a' = values a + force(f) for a generalised force f in newtons.
struct ModeSet {
  Eigen::VectorXcd values;                       ///< 2 n eigenvalues in 1/s
  Eigen::MatrixXcd vectors;                      ///< 2 n x 2 n
  Eigen::PartialPivLU<Eigen::MatrixXcd> factor;  ///< of vectors
  Eigen::MatrixXd inverse_mass;                  ///< n x n

  Eigen::VectorXcd force(const Eigen::VectorXcd& newtons) const;
};

/// With gyroscopic moments and rotating damping of this speed. Throws SolverError where the iteration does
/// not converge or the modes do not span the motion.
ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s);

}  // namespace rubsweep::fit
