#pragma once

#include <Eigen/Core>
#include <string>

namespace rubsweep::branch::orbits {

/// ",multiplier_1_re,...,floquet_modulus": the two largest multipliers of an orbit, and the largest modulus.
std::string multiplier_columns();

/// Cells of these columns; empty ones beyond the last multiplier. `multipliers`: largest modulus first, at
/// least one.
std::string multiplier_cells(const Eigen::VectorXcd& multipliers);

}  // namespace rubsweep::branch::orbits
