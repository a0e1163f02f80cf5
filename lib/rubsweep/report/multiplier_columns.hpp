#pragma once

#include <Eigen/Core>
#include <string>

namespace rubsweep::report {

/// ",multiplier_1_re,...,floquet_modulus": the two largest multipliers of an orbit, and the largest modulus.
std::string multiplier_columns();

/// The cells of these columns; empty ones where there are not so many. `multipliers`: largest modulus first,
/// at least one.
std::string multiplier_cells(const Eigen::VectorXcd& multipliers);

}  // namespace rubsweep::report
