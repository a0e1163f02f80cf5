#include "rubsweep/core/numerics/spectral/singular_values.hpp"

#include <Eigen/SVD>

namespace rubsweep::numerics::spectral {

SingularValues singular_values(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

}  // namespace rubsweep::numerics::spectral
