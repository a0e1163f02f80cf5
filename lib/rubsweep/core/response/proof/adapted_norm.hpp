#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace rubsweep::response::proof {

/// Norms |norm[i] x| on the sections of an orbit in which every turn is a contraction.
struct AdaptedNorms {
  std::vector<Eigen::MatrixXd> norm;  ///< per turn of the period, upper triangular; never below |x|
  double contraction = 0;             ///< |norm[i + 1] A_i x| <= contraction |norm[i] x|, < 1
};

/// Norms for the turns `transitions` (derivatives A_0, A_1, ... of one section by the one before) of an orbit
/// whose multipliers lie inside the unit circle: norm[i]^T norm[i] = P_i with
///   P_i = 1 + A_i^T P_{i+1} A_i / contraction^2,   P_n = P_0,
/// the discrete Lyapunov equation of the period, solved by doubling. `contraction` over the period lies
/// halfway between the largest multiplier and 1, so that the norms do not degenerate. In the maximum norm,
/// on the contrary, a disturbance that spirals in may seem to shrink where it only turns. Empty where the
/// largest multiplier is not below 1, or so near to it that rounding decides.
std::optional<AdaptedNorms> adapted_norms(const std::vector<Eigen::MatrixXd>& transitions);

}  // namespace rubsweep::response::proof
