#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "rubsweep/identify/free_rotor.hpp"
#include "rubsweep/numerics/dense/cholesky.hpp"

namespace rubsweep::identify {

/// A free whirl Re(shape e^{root t}) of a rotor that turns at one speed.
struct WhirlMode {
  std::complex<double> root_per_s;  ///< imaginary part > 0: the whirl frequency in rad/s
  Eigen::VectorXcd shape;           ///< n, in the coordinates of the rotor
  Eigen::VectorXcd state;           ///< 2n, of unit length in the norm of the energy at rest
  double forward_share = 0;         ///< of the mass-weighted squares, 0 to 1; 1 whirls as the shaft turns

  double frequency_hz() const;   ///< damped
  double damping_ratio() const;  ///< -Re root / |root|; negative: unstable
};

/// Modal assurance criterion: 0 for states that have nothing in common, 1 for the same motion.
double assurance(const WhirlMode& a, const WhirlMode& b);

/// The eigenproblem (root^2 mass + root (damping + speed gyroscopic) + stiffness + speed circulatory) shape =
/// 0 of a rotor. It is solved for states (w p, p') of mass-normalised coordinates p, w the frequency that
/// each has alone: all numbers are then rates, and the slowest modes come out as well as the fastest. Where
/// supports follow the speed, w is that at the speed of the modes.
class WhirlProblem {
 public:
  explicit WhirlProblem(const FreeRotor& rotor);

  /// All whirl modes at a speed, slowest first; overdamped modes have no whirl and are left out. Where roots
  /// coincide (forward and backward whirl of an isotropic rotor at rest), the modes are those that whirl most
  /// forward and most backward. Throws SolverError when the iteration does not converge.
  std::vector<WhirlMode> at(double speed_hz) const;

 private:
  WhirlMode mode_of(std::complex<double> root, const Eigen::VectorXcd& state) const;
  void part_by_direction(std::vector<WhirlMode>& modes) const;

  FreeRotor tabled_;  ///< where supports follow the speed, else empty
  numerics::dense::CholeskyFactors mass_;
  Eigen::VectorXd rad_per_s_;  ///< w
  Eigen::MatrixXd stiffness_, damping_, gyroscopic_, circulatory_;
  Eigen::MatrixXcd spin_;  ///< i spin, of the first n numbers of a state
};

}  // namespace rubsweep::identify
