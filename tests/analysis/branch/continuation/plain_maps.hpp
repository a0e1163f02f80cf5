#pragma once

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::test {

/// An orbit problem with one coordinate: `image(x, p)` and its derivative with respect to x.
template <class Image, class Slope>
branch::orbits::OrbitProblem one_number(const Image& image, const Slope& slope, double low, double high) {
  branch::orbits::OrbitProblem problem;
  problem.returns = [image, slope](double p, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    if (monodromy) *monodromy = Eigen::MatrixXd::Constant(1, 1, slope(x(0), p));
    x(0) = image(x(0), p);
    return branch::orbits::Evaluation::ok;
  };
  problem.low = low;
  problem.high = high;
  return problem;
}

/// The logistic map x -> r x (1 - x), applied `order` times.
inline branch::orbits::OrbitProblem logistic(int order, double low, double high) {
  branch::orbits::OrbitProblem problem;
  problem.order = order;
  problem.low = low;
  problem.high = high;
  problem.returns = [order](double r, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    double slope = 1;
    for (int k = 0; k < order; ++k) {
      slope *= r * (1 - 2 * x(0));
      x(0) = r * x(0) * (1 - x(0));
    }
    if (monodromy) *monodromy = Eigen::MatrixXd::Constant(1, 1, slope);
    return branch::orbits::Evaluation::ok;
  };
  return problem;
}

inline Eigen::VectorXd number(double x) { return Eigen::VectorXd::Constant(1, x); }

}  // namespace rubsweep::test
