#include "rubsweep/measurement/fit/residual_test.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace rubsweep::fit {
namespace {

constexpr std::size_t fewest = 24;
constexpr std::size_t lags = 8;
/// Lines are looked for among so many residuals at most, for the time that it takes.
constexpr std::size_t most_for_lines = 4096;

}  // namespace

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
    // Horner's rule: the turn to the power of the place.
    for (std::size_t j = part.size(); j > 0; --j) sum = sum * turn + (part[j - 1] - mean);
    const double share = 2 * std::norm(sum) / (static_cast<double>(part.size()) * energy);
    if (share > test.line_share) {
      test.line_share = share;
      test.line = static_cast<double>(k) / static_cast<double>(part.size());
    }
  }
  // Probability that noise makes one of m lines hold this share is about m (1 - share)^(m - 1).
  const auto m = static_cast<double>(lines);
  test.line_stands_out =
      std::log(m) + (m - 1) * std::log1p(-std::min(test.line_share, 1 - 1e-15)) < std::log(level);
  const double most = boost::math::quantile(boost::math::chi_squared(lags), 1 - level);
  test.white = test.portmanteau < most && !test.line_stands_out;
  return test;
}

}  // namespace rubsweep::fit
