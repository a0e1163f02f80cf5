#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/free_modes.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::linear {

/// The rotor of a machine without stops, casings and torsion, bending in x and y.
struct FreeRotor {
  structure::FullSystem full;  ///< a kit in all coordinates of its finite elements, nothing reduced
  /// n x n, skew: i q^H spin q is the mass-weighted sum of the squares of the forward whirl less that of the
  /// backward whirl, in units in which q^H mass q is the sum of both.
  Eigen::MatrixXd spin;
  std::vector<double> position_m;  ///< places along the shaft, ascending; of a Jeffcott rotor the disc, at 0
  Eigen::MatrixXd x, y;            ///< positions x n: deflections in metres = row * q
};

/// A kit with its structural damping, its stops among the places along the shaft; a Jeffcott rotor as it is.
/// The machine must be valid. Throws ConfigError where a ratio damps modes that cannot be computed.
FreeRotor free_rotor(const model::Machine& machine);

/// A free whirl Re(shape e^{root t}) of a rotor that turns at one speed.
struct WhirlMode {
  std::complex<double> root_per_s;  ///< imaginary part > 0: the whirl frequency in rad/s
  Eigen::VectorXcd shape;           ///< n, in the coordinates of the rotor
  Eigen::VectorXcd state;           ///< n, the shape in units in which its length is 1 by its mass
  double forward_share = 0;  ///< share of the mass-weighted squares, 0 to 1; 1 whirls as the shaft turns

  double frequency_hz() const;   ///< damped
  double damping_ratio() const;  ///< -Re root / |root|; negative: unstable
};

/// Whirl at one speed.
struct WhirlModes {
  std::vector<WhirlMode> modes;  ///< slowest first
  double growth_per_s = 0;  ///< rate of the vibration that grows fastest, also without whirl; 0: none does
};

/// Modal assurance criterion: 0 for states that have nothing in common, 1 for the same motion.
double assurance(const WhirlMode& a, const WhirlMode& b);

/// The eigenproblem (root^2 mass + root (damping + speed gyroscopic) + stiffness + speed circulatory) shape =
/// 0 of a rotor in all of its coordinates.
class WhirlProblem {
 public:
  /// Looks for whirl of at most `up_to_hz`, however damped, for the slowest two in any case, and for what
  /// grows. All rates are looked at at all of `speeds_hz` where that takes about a second, else at some of
  /// them, the first and the last among them. At the others whirl of at most `up_to_hz` is looked for among
  /// rates up to a thousand times that; faster whirl that is one of the slowest two, and what grows at a rate
  /// beyond four times `up_to_hz`, may be missed there. Throws SolverError where an iteration does not
  /// converge.
  WhirlProblem(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz);

  /// The whirl modes at a speed, slowest first; overdamped modes have no whirl and are left out. Where roots
  /// coincide (forward and backward whirl of an isotropic rotor at rest), the modes are those that whirl most
  /// forward and most backward. Faster ones than were asked for may be among them. A mode whose growth is no
  /// more than rounding of the matrices may cause has none. Throws SolverError as the constructor.
  WhirlModes at(double speed_hz) const;

  /// The mode at a speed that continues one of a speed nearby; empty where it is not certain which one that
  /// is.
  std::optional<WhirlMode> continued(const WhirlMode& mode, double speed_hz) const;

 private:
  structure::SpeedMatrices matrices(double speed_hz) const;
  WhirlMode mode_of(std::complex<double> root, const Eigen::VectorXcd& shape,
                    const Eigen::MatrixXd& mass) const;
  void part_by_direction(std::vector<WhirlMode>& modes, const Eigen::MatrixXd& mass) const;

  structure::FullSystem full_;
  numerics::dense::CholeskyFactors mass_;
  Eigen::MatrixXcd spin_;  ///< i spin
  std::vector<structure::RateDisc> discs_;
};

}  // namespace rubsweep::linear
