#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace rubsweep::response {

/// d(state)/d(phase) of an autonomous system, 2n numbers, and its 2n x 2n derivative.
struct TurningEquations {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> rate;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;
};

/// A synchronous circle: a stable fixed point in the frame that turns with the shaft.
struct TurningCircle {
  Eigen::VectorXd state;
  double floquet_modulus = 0;  ///< over one turn: e^{2 pi Re lambda}, lambda the rightmost eigenvalue
};

/// Proves that a transient that was at `before` one turn ago and is at `now` (both in the turning frame)
/// settles on a fixed point: Newton's iteration finds it, its multipliers over one turn lie inside
/// `largest_floquet_modulus`, and the last turn took the transient where the linear system about it says, to
/// a tenth of its distance and to less than the multipliers shorten that. Empty when any of this fails.
std::optional<TurningCircle> prove_circle(const TurningEquations& equations, const Eigen::VectorXd& before,
                                          const Eigen::VectorXd& now);

}  // namespace rubsweep::response
