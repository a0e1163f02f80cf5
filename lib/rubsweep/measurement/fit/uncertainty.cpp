#include "rubsweep/measurement/fit/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"

namespace rubsweep::fit {
namespace {

/// Fewest instants from which a correlation can be estimated.
constexpr Eigen::Index fewest_instants = 24;
/// Squared singular values below this share of the largest one are only rounding.
constexpr double noise_rounding = 1e-6;
constexpr Eigen::Index shortest_block = 4, fewest_blocks = 10;

/// Correlation of neighbouring residuals, over all rows together.
double neighbours_correlation(const Eigen::VectorXd& residuals, const RowsInTime& in_time) {
  double product = 0, square = 0;
  for (Eigen::Index j = 0; j < in_time.rows; ++j) {
    const auto row = residuals.segment(in_time.begin + j * in_time.instants, in_time.instants);
    product += row.head(in_time.instants - 1).dot(row.tail(in_time.instants - 1));
    square += row.squaredNorm();
  }
  return square > 0 ? product / square : 0;
}

/// Sums over blocks. `moved`: squared changes of the fit when a block is left out. `share`: each block's
/// share of the variance, for white noise, summed; `share_squared`: the sum of the squares of these shares.
struct BlockSums {
  Eigen::VectorXd moved, share, share_squared;
};

/// Adds to `sums` the contributions of the blocks into which the rows `in_time` are divided. The columns of
/// `jacobian` have length 1; `normal` is their normal matrix.
void add_blocks(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& normal,
                const Eigen::VectorXd& residuals, const RowsInTime& in_time, BlockSums& sums) {
  const Eigen::Index length = block_length(residuals, in_time), blocks = in_time.instants / length;
  const Eigen::MatrixXd inverse = numerics::dense::FullPivotFactors(normal).inverse();
  for (Eigen::Index b = 0; b < blocks; ++b) {
    // The lengths of blocks differ by one instant at most.
    const Eigen::Index from = b * in_time.instants / blocks;
    const Eigen::Index count = (b + 1) * in_time.instants / blocks - from;
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(normal.rows(), normal.cols());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(normal.rows());
    for (Eigen::Index j = 0; j < in_time.rows; ++j) {
      const Eigen::Index begin = in_time.begin + j * in_time.instants + from;
      const auto part = jacobian.middleRows(begin, count);
      own += part.transpose() * part;
      gradient += part.transpose() * residuals.segment(begin, count);
    }
    const Eigen::VectorXd moved = numerics::dense::solve_full_pivot(normal - own, gradient);
    const Eigen::VectorXd share = (inverse * own * inverse).diagonal();
    const double of_blocks = static_cast<double>(blocks - 1) / static_cast<double>(blocks);
    sums.moved += of_blocks * moved.cwiseAbs2();
    sums.share += share;
    sums.share_squared += share.cwiseAbs2();
  }
}

constexpr std::size_t fewest = 24;
constexpr std::size_t lags = 8;
/// Limit of the number of residuals in the search for a line, to save time.
constexpr std::size_t most_for_lines = 4096;

}  // namespace

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
    // A column that is only rounding has a length, too, so the standard error is compared with the bounds.
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

Eigen::Index block_length(const Eigen::VectorXd& residuals, const RowsInTime& in_time) {
  constexpr double strongest = 0.97;
  const double r = std::clamp(neighbours_correlation(residuals, in_time), -strongest, strongest);
  const double alpha = std::pow(2 * r / ((1 - r) * (1 + r)), 2);
  const double andrews = 1.1447 * std::cbrt(alpha * static_cast<double>(in_time.instants));
  return std::clamp(static_cast<Eigen::Index>(std::ceil(andrews)), shortest_block,
                    std::max(shortest_block, in_time.instants / fewest_blocks));
}

void allow_for_correlation(const LeastSquaresFit& fit, const std::vector<RowsInTime>& in_time,
                           Uncertainty& uncertainty) {
  const Eigen::Index count = fit.value.size();
  const Eigen::VectorXd length = fit.jacobian.colwise().norm().transpose();
  if (!(length.minCoeff() > 0) ||
      !(uncertainty.singular(count - 1) > noise_rounding * uncertainty.singular(0)))
    return;
  const Eigen::MatrixXd jacobian = fit.jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(count);
  BlockSums sums{none, none, none};
  Eigen::VectorXd white = Eigen::VectorXd::Ones(fit.residuals.size());
  for (const RowsInTime& rows : in_time) {
    if (rows.instants < fewest_instants) continue;
    add_blocks(jacobian, normal, fit.residuals, rows, sums);
    white.segment(rows.begin, rows.instants * rows.rows).setZero();
  }
  const Eigen::MatrixXd inverse = numerics::dense::FullPivotFactors(normal).inverse();
  const Eigen::VectorXd beside =
      (inverse * jacobian.transpose() * white.asDiagonal() * jacobian * inverse).diagonal();
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!(sums.share_squared(i) > 0)) continue;
    const double variance = sums.moved(i) + std::pow(uncertainty.residual_rms, 2) * beside(i);
    const double error = std::sqrt(variance) / length(i);
    const double freedom = std::max(1.0, std::pow(sums.share(i), 2) / sums.share_squared(i));
    const double wide = boost::math::quantile(boost::math::students_t(freedom), 0.975) * error;
    uncertainty.standard_error(i) = std::max(uncertainty.standard_error(i), error);
    uncertainty.half_width(i) = std::max(uncertainty.half_width(i), wide);
  }
}

ResidualTest test_residuals(std::span<const double> residuals, double level) {
  ResidualTest test;
  const std::size_t count = residuals.size();
  if (count < fewest) return test;
  double mean = 0;
  for (const double value : residuals) mean += value / static_cast<double>(count);
  const auto covariance = [&](std::span<const double> part, std::size_t lag) {
    double sum = 0;
    for (std::size_t k = lag; k < part.size(); ++k) sum += (part[k] - mean) * (part[k - lag] - mean);
    return sum;
  };
  const double variance = covariance(residuals, 0);
  if (!(variance > 0)) return test;
  const auto n = static_cast<double>(count);
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    const double correlation = covariance(residuals, lag) / variance;
    if (lag == 1) test.first_correlation = correlation;
    test.portmanteau += n * (n + 2) * correlation * correlation / (n - static_cast<double>(lag));
  }
  const auto part = residuals.first(std::min(count, most_for_lines));
  const double energy = covariance(part, 0);
  const std::size_t lines = (part.size() - 1) / 2;
  for (std::size_t k = 1; k <= lines; ++k) {
    std::complex<double> sum = 0;
    const std::complex<double> turn =
        std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(part.size()));
    // Horner's rule for the Fourier sum.
    for (std::size_t j = part.size(); j > 0; --j) sum = sum * turn + (part[j - 1] - mean);
    const double share = 2 * std::norm(sum) / (static_cast<double>(part.size()) * energy);
    if (share > test.line_share) {
      test.line_share = share;
      test.line = static_cast<double>(k) / static_cast<double>(part.size());
    }
  }
  // Noise alone makes the largest of m lines reach this share with a probability of about m (1 - share)^(m -
  // 1).
  const auto m = static_cast<double>(lines);
  test.line_stands_out =
      std::log(m) + (m - 1) * std::log1p(-std::min(test.line_share, 1 - 1e-15)) < std::log(level);
  const double most = boost::math::quantile(boost::math::chi_squared(lags), 1 - level);
  test.white = test.portmanteau < most && !test.line_stands_out;
  return test;
}

}  // namespace rubsweep::fit
