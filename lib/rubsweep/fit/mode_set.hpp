#pragma once

#include <Eigen/Core>

#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::fit {

/// Vibration modes of a machine without its contacts at one shaft speed: the state (q, q') is vectors * a,
/// with a' = values a + force * f for a generalised force f in newtons.
struct ModeSet {
  Eigen::VectorXcd values;   ///< 2 n eigenvalues in 1/s
  Eigen::MatrixXcd vectors;  ///< 2 n x 2 n
  Eigen::MatrixXcd force;    ///< 2 n x n
  Eigen::MatrixXcd inverse;  ///< of vectors
};

/// With gyroscopic moments and rotating damping of this speed. Throws SolverError where the iteration does
/// not converge or the modes do not span the motion.
ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s);

}  // namespace rubsweep::fit
