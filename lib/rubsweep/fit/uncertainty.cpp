#include "rubsweep/fit/uncertainty.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/error.hpp"

namespace rubsweep::fit {

double student_975(int degrees_of_freedom) {
  constexpr std::array<double, 4> exact{12.7062, 4.30265, 3.18245, 2.77645};
  if (degrees_of_freedom <= 4) return exact[static_cast<std::size_t>(std::max(degrees_of_freedom, 1) - 1)];
  // Cornish and Fisher's expansion about the normal quantile (Abramowitz and Stegun 26.7.5).
  const double z = 1.959963984540054, n = degrees_of_freedom;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

Uncertainty uncertainty_of(const LeastSquaresFit& fit, int eliminated) {
  const Eigen::Index count = fit.value.size();
  Uncertainty found;
  found.degrees_of_freedom = static_cast<int>(fit.residuals.size() - count) - eliminated;
  if (found.degrees_of_freedom < 1)
    throw ConfigError(fmt::format(
        "{} numbers of data cannot tell {} parameters and {} offsets, allowed: fewer keys or more data",
        fit.residuals.size(), count, eliminated));
  found.residual_rms = std::sqrt(fit.residuals.squaredNorm() / found.degrees_of_freedom);
  Eigen::VectorXd length = fit.jacobian.colwise().norm().transpose();
  Eigen::MatrixXd normed = fit.jacobian;
  for (Eigen::Index i = 0; i < count; ++i)
    if (length(i) > 0) normed.col(i) /= length(i);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(normed, Eigen::ComputeThinV);
  found.singular = svd.singularValues();
  found.direction = svd.matrixV();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  constexpr double rounding = 1e-9;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double value = std::max(found.singular(k), rounding * found.singular(0));
    covariance += found.direction.col(k) * found.direction.col(k).transpose() / (value * value);
  }
  found.standard_error.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
    found.standard_error(i) =
        length(i) > 0 ? found.residual_rms * std::sqrt(covariance(i, i)) / length(i) : INFINITY;
  found.half_width = student_975(found.degrees_of_freedom) * found.standard_error;
  found.correlation = covariance;
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      found.correlation(i, j) /= std::sqrt(covariance(i, i) * covariance(j, j));
  return found;
}

std::vector<std::string> untold_combinations(const Uncertainty& uncertainty,
                                             const std::vector<Parameter>& parameters) {
  constexpr double share = 0.2;
  std::vector<std::string> sentences;
  for (Eigen::Index i = 0; i < uncertainty.standard_error.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    // A derivative that is rounding alone has a length too.
    if (parameter.high > parameter.low && uncertainty.standard_error(i) > parameter.high - parameter.low)
      sentences.push_back(fmt::format("the data do not tell {}", parameter.name));
  }
  for (Eigen::Index k = 0; k < uncertainty.singular.size(); ++k) {
    if (uncertainty.singular(k) > untold * uncertainty.singular(0)) continue;
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < uncertainty.direction.rows(); ++i) {
      if (std::abs(uncertainty.direction(i, k)) > share)
        names.push_back(parameters[static_cast<std::size_t>(i)].name);
    }
    sentences.push_back(names.size() == 1
                            ? fmt::format("the data do not tell {}", names.front())
                            : fmt::format("the data do not tell {} apart (singular value {:.1e})",
                                          fmt::join(names, ", "), uncertainty.singular(k)));
  }
  return sentences;
}

}  // namespace rubsweep::fit
