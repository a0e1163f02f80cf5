#include "rubsweep/numerics/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace rubsweep::numerics {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) { return matrix.eigenvalues(); }

double spectral_radius(const Eigen::MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

}  // namespace rubsweep::numerics
