#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace rubsweep::response::rotating {

/// Rate d(state)/d(phase) of an autonomous system, 2n numbers, and its 2n x 2n derivative.
struct RotatingEquations {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> rate;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;
};

/// A synchronous circle: a stable fixed point in the frame that turns with the shaft.
struct RotatingEquilibrium {
  Eigen::VectorXd state;
  Eigen::MatrixXd transition;  ///< over one turn
  double floquet_modulus = 0;  ///< over one turn: e^{2 pi Re lambda}, lambda the rightmost eigenvalue
};

/// Newton's iteration from `start` (in the rotating frame) for a fixed point whose multipliers over one turn
/// lie inside `largest_floquet_modulus`. Empty where it finds none within `farthest_orbit`.
std::optional<RotatingEquilibrium> find_rotating_equilibrium(const RotatingEquations& equations,
                                                             const Eigen::VectorXd& start);

}  // namespace rubsweep::response::rotating
