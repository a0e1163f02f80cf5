#include "rubsweep/ring/eigenvalues.hpp"

#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/lu.hpp"

namespace rubsweep::ring {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// Where several roots merge at once Eigen's own limit may be too low.
constexpr Index iterations_per_row = 4000;

numerics::dense::GeneralModes solve(const MatrixXd& matrix, bool with_vectors) {
  numerics::dense::GeneralModes modes =
      numerics::dense::general_modes(matrix, with_vectors, iterations_per_row);
  if (!modes.converged) throw SolverError("the eigenvalue iteration did not converge");
  return modes;
}

}  // namespace

Eigen::VectorXcd eigenvalues(const NormalForm& form, double speed_rad_per_s) {
  return form.reference_rad_per_s * solve(state_matrix(form, speed_rad_per_s), false).values;
}

Spectrum spectrum(const NormalForm& form, double speed_rad_per_s) {
  numerics::dense::GeneralModes all = solve(state_matrix(form, speed_rad_per_s), true);
  Spectrum result;
  result.vectors = std::move(all.vectors);
  result.values = form.reference_rad_per_s * all.values;
  // Rows of the inverse are the left eigenvectors, scaled to y^H x = 1.
  const MatrixXcd left = numerics::dense::inverse(result.vectors);
  const MatrixXcd moved = state_matrix_slope(form, speed_rad_per_s) * result.vectors;
  result.slopes.resize(result.values.size());
  for (Index i = 0; i < result.values.size(); ++i) {
    const std::complex<double> slope = left.row(i) * moved.col(i);
    result.slopes(i) = std::isfinite(std::abs(slope)) ? slope : 0;
  }
  return result;
}

double size_of(const Eigen::VectorXcd& values) { return values.cwiseAbs().maxCoeff(); }

double zero_tolerance(const NormalForm& form) { return form.has_friction ? 1e-11 : 1e-7; }

Signature signature(const NormalForm& form, const Eigen::VectorXcd& values) {
  const double size = size_of(values), zero = zero_tolerance(form) * size;
  // Equal real roots of uncoupled loads may come out as a pair this close to the axis.
  const double equal = 1e-7 * size;
  Signature counts;
  for (const std::complex<double>& value : values) {
    const bool grows = value.real() > zero;
    if (std::abs(value.imag()) <= equal) {
      ++(grows ? counts.growing_real : counts.decaying_real);
    } else if (value.imag() > 0 && grows) {
      ++counts.growing_pairs;
    }
  }
  return counts;
}

Signature signature(const NormalForm& form, double speed_rad_per_s) {
  return signature(form, eigenvalues(form, speed_rad_per_s));
}

}  // namespace rubsweep::ring
