#pragma once

#include <Eigen/Core>

#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {

/// Disc in the complex plane that selects rates s of free vibrations: |s - centre| <= radius, per second.
struct RateDisc {
  double centre = 0;  ///< on the real axis
  double radius = 1;
};

/// Free vibrations Re(shape e^{rate t}): (rate^2 mass + rate damping + stiffness) shape = 0. Both members of
/// each conjugate pair are listed.
struct FreeModes {
  Eigen::VectorXcd rate_per_s;
  Eigen::MatrixXcd shape;  ///< one column each, normalised to length 1
};

/// All free vibrations in a disc, double ones listed twice; a coordinate without mass has none. They come
/// from a block Krylov space of the inverse about the centre, in which the rates nearest to the centre
/// converge first. The space grows until all vibrations in the disc solve the equations to rounding, if
/// necessary to the full space. Throws SolverError where the centre is itself a rate or an iteration does not
/// converge.
FreeModes free_modes(const SpeedMatrices& matrices, const RateDisc& disc);

/// Rates of all free vibrations; most precise for rates of the order of `unit_per_s`. Only for small
/// matrices, because it uses the full space.
Eigen::VectorXcd all_rates_per_s(const SpeedMatrices& matrices, double unit_per_s);

/// The vibration that continues the one of `rate_per_s` and `shape` at changed matrices, by Newton's method:
/// shape and rate are replaced. False where the iteration does not converge: the relative change of the rate
/// still exceeds `precision`.
bool follow_free_mode(const SpeedMatrices& matrices, std::complex<double>& rate_per_s,
                      Eigen::VectorXcd& shape, double precision = 0x1p-50);

/// Error of a vibration's rate, per second, caused by rounding the numbers of these matrices.
double rate_rounding_per_s(const SpeedMatrices& matrices, std::complex<double> rate_per_s,
                           const Eigen::VectorXcd& shape);

}  // namespace rubsweep::structure
