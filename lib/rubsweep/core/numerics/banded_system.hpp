#pragma once

#include <Eigen/Core>
#include <initializer_list>

namespace rubsweep::numerics {

/// Bandwidth of several matrices: largest distance of a non-zero entry from the diagonal.
Eigen::Index band_of(std::initializer_list<const Eigen::MatrixXd*> matrices);

/// a^-1 b where all numbers of `a` stand at most `band` places off its diagonal, which may be as many as it
/// has: by elimination with pivots of the columns, some hundred rows of which take a fraction of the time of
/// Eigen's complex numbers. Not finite where `a` is singular.
Eigen::MatrixXcd solve_banded(Eigen::MatrixXcd a, Eigen::MatrixXcd b, Eigen::Index band);

}  // namespace rubsweep::numerics
