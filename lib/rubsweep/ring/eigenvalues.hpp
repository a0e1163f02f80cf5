#pragma once

#include <Eigen/Core>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

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
