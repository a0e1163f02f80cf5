#include "rubsweep/fit/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <utility>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/spectral/singular_values.hpp"

namespace rubsweep::fit {

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
  numerics::spectral::SingularValues decomposed = numerics::spectral::singular_values(normed);
  found.singular = std::move(decomposed.values);
  found.direction = std::move(decomposed.v);
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
  const boost::math::students_t student(found.degrees_of_freedom);
  found.half_width = boost::math::quantile(student, 0.975) * found.standard_error;
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
    std::string sentence = names.size() == 1
                               ? fmt::format("the data do not tell {}", names.front())
                               : fmt::format("the data do not tell {} apart (singular value {:.1e})",
                                             fmt::join(names, ", "), uncertainty.singular(k));
    if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace rubsweep::fit
