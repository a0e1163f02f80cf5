#pragma once

#include <Eigen/Core>
#include <string>

namespace rubsweep::branch::orbits {

/// Header ",multiplier_1_re,...,floquet_modulus" for the two largest multipliers and the largest modulus.
std::string multiplier_columns();

/// Cells for multiplier_columns(), empty where there are fewer than two multipliers. `multipliers`: at least
/// one, the largest modulus first.
std::string multiplier_cells(const Eigen::VectorXcd& multipliers);

/// Eigenvalues of a monodromy matrix, the largest modulus first; in a complex pair the positive imaginary
/// part first.
Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& monodromy);

int count_outside(const Eigen::VectorXcd& multipliers);

/// det(M + 1): changes sign where one multiplier passes -1.
double doubling_test(const Eigen::VectorXcd& multipliers);

/// det(1 - M): changes sign where one multiplier passes +1.
double unit_test(const Eigen::VectorXcd& multipliers);

/// Product of (a b - 1) over all pairs a, b of multipliers. It is the determinant of the bialternate product
/// of the monodromy matrix with itself minus 1, a real and smooth function. It is zero where a complex pair
/// lies on the unit circle, but also where two real multipliers have the product 1.
double torus_test(const Eigen::VectorXcd& multipliers);

/// Whether the pair of multipliers whose product is nearest to 1 is a complex pair.
bool nearest_pair_is_complex(const Eigen::VectorXcd& multipliers);

}  // namespace rubsweep::branch::orbits
