#pragma once

#include <Eigen/Core>

#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {

/// Rates s of free vibrations that are asked for: those with |s - centre| <= radius, per second.
struct RateDisc {
  double centre = 0;  ///< real
  double radius = 1;
};

/// Free vibrations Re(shape e^{rate t}): (rate^2 mass + rate damping + stiffness) shape = 0, both of each
/// pair of conjugates.
struct FreeModes {
  Eigen::VectorXcd rate_per_s;
  Eigen::MatrixXcd shape;  ///< columns, of the length 1
};

/// All free vibrations in a disc, double ones twice; a coordinate without mass has none. They come from a
/// block Krylov space of the inverse about the centre, in which those next to the centre settle first: it
/// grows until all in the disc solve the equations to rounding, at last to the whole space. Throws
/// SolverError where the centre is a rate itself or an iteration does not converge.
FreeModes free_modes(const SpeedMatrices& matrices, const RateDisc& disc);

/// Rates of all free vibrations, as precise as `unit_per_s` is near to them; for few matrices, because it
/// takes the whole space.
Eigen::VectorXcd all_rates_per_s(const SpeedMatrices& matrices, double unit_per_s);

/// The vibration next to `rate_per_s` and `shape` at other matrices, by Newton's method: shape and rate are
/// replaced. False where it does not converge: the rate still moves by more than `precision` of itself.
bool follow_free_mode(const SpeedMatrices& matrices, std::complex<double>& rate_per_s,
                      Eigen::VectorXcd& shape, double precision = 0x1p-50);

/// How far rounding of the numbers of these matrices may move the rate of a vibration, per second.
double rate_rounding_per_s(const SpeedMatrices& matrices, std::complex<double> rate_per_s,
                           const Eigen::VectorXcd& shape);

}  // namespace rubsweep::structure
