#include "rubsweep/ring/divergence.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/numerics/dense/lu.hpp"

namespace rubsweep::ring {

std::vector<double> divergence_speeds(const NormalForm& form) {
  // 1 / O^2 rather than O^2: K2 may be singular (loads without mass), K0 holds every spring.
  const Eigen::MatrixXd inverse = numerics::dense::solve_full_pivot(form.stiffness, form.softening);
  const Eigen::VectorXcd roots = numerics::dense::eigenvalues(inverse);
  if (roots.hasNaN()) throw SolverError("divergence: the eigenvalue iteration did not converge");
  const double largest = roots.cwiseAbs().maxCoeff();
  std::vector<double> speeds;
  for (const std::complex<double>& root : roots) {
    // Equal roots of identical loads may come out as a pair that close to the axis.
    if (std::abs(root.imag()) > 1e-9 * largest || !(root.real() > 1e-14 * largest)) continue;
    speeds.push_back(form.reference_rad_per_s / std::sqrt(root.real()));
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

}  // namespace rubsweep::ring
