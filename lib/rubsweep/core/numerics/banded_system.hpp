#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <initializer_list>

namespace rubsweep::numerics {

/// Bandwidth of several matrices: largest distance of a non-zero entry from the diagonal.
Eigen::Index band_of(std::initializer_list<const Eigen::MatrixXd*> matrices);

/// a^-1 b by elimination with column pivoting, where all non-zero numbers of `a` are at most `band` places
/// away from its diagonal (`band` may be as large as the matrix). `entry(row, column)` gives a number of `a`,
/// and is asked for those within the band alone. With some hundred rows it takes a fraction of the time of
/// Eigen's complex solver. Not finite where `a` is singular.
Eigen::MatrixXcd solve_banded(
    const std::function<std::complex<double>(Eigen::Index row, Eigen::Index column)>& entry,
    Eigen::MatrixXcd b, Eigen::Index band);

}  // namespace rubsweep::numerics
