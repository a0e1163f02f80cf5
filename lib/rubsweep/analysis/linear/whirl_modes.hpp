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

/// Rotor of a machine in bending in x and y, without stops, casings and torsion.
struct FreeRotor {
  structure::FullSystem full;  ///< kit with all coordinates of its finite elements, without reduction
  /// Skew n x n matrix: i q^H spin q is the mass-weighted sum of squares of the forward whirl minus that of
  /// the backward whirl; q^H mass q is the sum of the two.
  Eigen::MatrixXd spin;
  std::vector<double> position_m;  ///< places along the shaft, ascending; Jeffcott rotor: the disc, at 0
  Eigen::MatrixXd x, y;            ///< positions x n: deflections in metres = row * q
};

/// Rotor of a valid machine: a kit with its structural damping and with its stops among the places along the
/// shaft, or a Jeffcott rotor. Throws ConfigError where damping ratios are given for modes that cannot be
/// computed.
FreeRotor free_rotor(const model::Machine& machine);

/// Free whirl Re(shape e^{root t}) of a rotor at one shaft speed.
struct WhirlMode {
  std::complex<double> root_per_s;  ///< eigenvalue; its imaginary part > 0 is the whirl frequency in rad/s
  Eigen::VectorXcd shape;           ///< n, in the coordinates of the rotor
  Eigen::VectorXcd state;           ///< n, the shape scaled to length 1 in the norm of the mass matrix
  double forward_share = 0;  ///< forward share of the mass-weighted squares, 0 to 1; 1: whirls with the shaft

  double frequency_hz() const;   ///< damped natural frequency
  double damping_ratio() const;  ///< -Re root / |root|; negative: unstable
};

/// Whirl modes at one speed.
struct WhirlModes {
  std::vector<WhirlMode> modes;  ///< slowest first
  double growth_per_s = 0;  ///< largest growth rate of a free vibration, with or without whirl; 0: none grows
};

/// Modal assurance criterion: 0 for orthogonal states, 1 for the same motion.
double assurance(const WhirlMode& a, const WhirlMode& b);

/// Eigenvalue problem of a rotor in all of its coordinates: (root^2 mass + root (damping + speed gyroscopic)
/// + stiffness + speed circulatory) shape = 0.
class WhirlProblem {
 public:
  /// Finds regions of the complex plane that contain all wanted roots: whirl of at most `up_to_hz`, whatever
  /// its damping, the two slowest whirls, and all growing motions. If this takes no more than about a second,
  /// all roots are computed at all `speeds_hz`, otherwise only at some of them, including the first and the
  /// last. At the remaining speeds, whirl of at most `up_to_hz` is sought among rates up to a thousand times
  /// larger. Two kinds of roots may be missed there: faster whirl that is one of the two slowest, and growth
  /// at rates above four times `up_to_hz`. Throws SolverError where an iteration does not converge.
  WhirlProblem(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz);

  /// Whirl modes at a speed, the slowest first; overdamped modes have no whirl and are left out. If roots
  /// coincide (forward and backward whirl of an isotropic rotor at rest), the modes are the combinations with
  /// the most forward and the most backward whirl. Faster modes than `up_to_hz` may be included. Growth that
  /// may be caused by rounding of the matrices is set to 0. Throws SolverError as the constructor does.
  WhirlModes at(double speed_hz) const;

  /// Mode at `speed_hz` that continues `mode` from a nearby speed; empty where no mode is surely the same.
  std::optional<WhirlMode> continued(const WhirlMode& mode, double speed_hz) const;

 private:
  structure::SpeedMatrices matrices(double speed_hz) const;
  WhirlMode mode_of(std::complex<double> root, const Eigen::VectorXcd& shape,
                    const Eigen::MatrixXd& mass) const;
  void part_by_direction(std::vector<WhirlMode>& modes, const Eigen::MatrixXd& mass) const;

  structure::FullSystem full_;
  numerics::dense::CholeskyFactors mass_;
  Eigen::MatrixXcd spin_;  ///< i times the matrix spin
  std::vector<structure::RateDisc> discs_;
};

}  // namespace rubsweep::linear
