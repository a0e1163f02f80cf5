#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/ring/system.hpp"

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

/// M X'' + Omega C X' + (K0 - Omega^2 K2) X = F0 + Omega^2 F2, SI. X = (A, B, q of every load that has a
/// coordinate), q the tangential deflection of the load's tip. Friction makes all of them asymmetric.
struct Matrices {
  Eigen::MatrixXd mass;         ///< M
  Eigen::MatrixXd rotation;     ///< C: gyroscopic and circulatory terms for Omega = 1 rad/s
  Eigen::MatrixXd stiffness;    ///< K0
  Eigen::MatrixXd softening;    ///< K2
  Eigen::VectorXd force;        ///< F0: by the preload
  Eigen::VectorXd centrifugal;  ///< F2; zero without a radius of the ring

  Eigen::Index coordinates() const { return mass.rows(); }
};

/// Regular at every inclination: with q instead of the beam's own flexure v no tan(alpha) appears; the
/// eigenvalues are those of Appendix A (as corrected, see results/ring_findings.txt) for |alpha| < 90
/// degrees.
Matrices assemble(const System& system);

/// Premises of the linear model at one speed, one entry per load.
struct StaticLoad {
  std::vector<double> normal_n;  ///< force of the load on the ring in the steady state; positive: it presses
  std::vector<double> slip_m_per_s;  ///< speed of the tip over the ring's surface in the steady state

  /// Whether every load presses and slips forward, as the model assumes of contact and friction.
  bool valid() const;
};

/// Steady state under preload and centrifugal force. Where K is singular the forces are not finite. Needs the
/// radius of the ring.
StaticLoad static_load(const System& system, double speed_rad_per_s);

/// All 2N eigenvalues lambda (1/s) of the system turning at one speed, complex ones in conjugate pairs.
/// Throws SolverError when the iteration does not converge.
Eigen::VectorXcd eigenvalues(const NormalForm& form, double speed_rad_per_s);

/// Eigenvalues with the quantities that distinguish modes.
struct Spectrum {
  Eigen::VectorXcd values;  ///< 1/s
  /// d lambda / d Omega, by left and right eigenvectors; 0 where they are defective.
  Eigen::VectorXcd slopes;
  Eigen::MatrixXcd vectors;  ///< columns (Y, Y') of the normal form, of unit length
};
Spectrum spectrum(const NormalForm& form, double speed_rad_per_s);

/// Largest |lambda|.
double size_of(const Eigen::VectorXcd& values);

/// Tolerance below which a real or imaginary part counts as zero, in units of the largest |lambda|. Without
/// friction every stable root is neutral and onsets are double roots, known to the square root of the
/// rounding; with friction the roots that cross are simple.
double zero_tolerance(const NormalForm& form);

/// Counts that change at every onset.
struct Signature {
  int growing_real = 0;   ///< real roots above zero: divergence
  int decaying_real = 0;  ///< real roots at zero or below
  int growing_pairs = 0;  ///< complex pairs with a positive real part: flutter

  bool stable() const { return growing_real == 0 && growing_pairs == 0; }
  int unstable_eigenvalues() const { return growing_real + 2 * growing_pairs; }
  bool operator==(const Signature&) const = default;
};
Signature signature(const NormalForm& form, const Eigen::VectorXcd& values);
Signature signature(const NormalForm& form, double speed_rad_per_s);

}  // namespace rubsweep::ring
