#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Scaled equation Y'' + O S1 Y' + (S0 - O^2 S2) Y = 0. Coordinates are scaled by the mass diagonal, the
/// equation is multiplied by M^-1, time is in units of 1 / reference, and O = Omega / reference. All entries
/// are then of order one.
struct NormalForm {
  Eigen::MatrixXd rotation;   ///< S1
  Eigen::MatrixXd stiffness;  ///< S0
  Eigen::MatrixXd softening;  ///< S2
  double reference_rad_per_s = 1;
  bool has_friction = false;

  Eigen::Index coordinates() const { return stiffness.rows(); }
};

/// Scales a system. Throws ConfigError where the mass matrix is singular: a load that can move has no mass,
/// or the friction coefficient makes the friction force cancel the inertia.
NormalForm normal_form(const System& system);

/// Matrices of M X'' + Omega C X' + (K0 - Omega^2 K2) X = F0 + Omega^2 F2, in SI. X = (A, B, q of every load
/// with a coordinate), where q is the tangential deflection of the load's tip. Friction makes all matrices
/// asymmetric.
struct Matrices {
  Eigen::MatrixXd mass;         ///< M
  Eigen::MatrixXd rotation;     ///< C: gyroscopic and circulatory terms for Omega = 1 rad/s
  Eigen::MatrixXd stiffness;    ///< K0
  Eigen::MatrixXd softening;    ///< K2
  Eigen::VectorXd force;        ///< F0, the force of the preload
  Eigen::VectorXd centrifugal;  ///< F2; zero for a ring without a radius

  Eigen::Index coordinates() const { return mass.rows(); }
};

/// Assembles the matrices. They are regular at every inclination: with q instead of the beam's deflection v
/// there is no tan(alpha). For |alpha| < 90 degrees the eigenvalues are those of Appendix A (as corrected,
/// see results/ring_findings.txt).
Matrices assemble(const System& system);

/// Quantities at one speed that the linear model assumes to be positive, one entry per load.
struct StaticLoad {
  std::vector<double> normal_n;  ///< force of the load on the ring in the steady state; > 0: the load presses
  std::vector<double> slip_m_per_s;  ///< steady speed of the tip relative to the ring's surface

  bool valid() const;  ///< Whether every load presses on the ring and slips forward, as the model assumes.
};

/// Steady state under preload and centrifugal force. Forces are not finite where K is singular. The ring must
/// have a radius.
StaticLoad static_load(const System& system, double speed_rad_per_s);

/// All 2N eigenvalues lambda (1/s) at one speed, complex ones in conjugate pairs. Throws SolverError where
/// the iteration does not converge.
Eigen::VectorXcd eigenvalues(const NormalForm& form, double speed_rad_per_s);

/// Eigenvalues, with their slopes and eigenvectors, which distinguish modes.
struct Spectrum {
  Eigen::VectorXcd values;  ///< 1/s
  /// d lambda / d Omega, from left and right eigenvectors; 0 where the eigenvectors are defective.
  Eigen::VectorXcd slopes;
  Eigen::MatrixXcd vectors;  ///< columns (Y, Y') of the normal form, each of length 1
};
Spectrum spectrum(const NormalForm& form, double speed_rad_per_s);

double size_of(const Eigen::VectorXcd& values);  ///< Largest |lambda| in 1/s.
/// Index of the eigenvalue nearest to `place`.
Eigen::Index nearest_to(std::complex<double> place, const Eigen::VectorXcd& values);

/// Tolerance below which a real or imaginary part counts as zero, relative to the largest |lambda|. Without
/// friction all stable roots are neutral and onsets are double roots, which are accurate only to the square
/// root of rounding. With friction the crossing roots are simple.
double zero_tolerance(const NormalForm& form);

/// Numbers of roots by kind; at least one of them changes at every onset.
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
