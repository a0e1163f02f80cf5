#include "rubsweep/measurement/scope/mean_period.hpp"

#include <numbers>

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;

}  // namespace

std::span<const Complex> whole_periods(std::span<const Complex> samples, std::size_t period) {
  return samples.last(samples.size() / period * period);
}

std::vector<Complex> mean_period(std::span<const Complex> samples, std::size_t period) {
  std::vector<Complex> mean(period);
  for (std::size_t k = 0; k < samples.size(); ++k) mean[k % period] += samples[k];
  for (Complex& z : mean) z /= static_cast<double>(samples.size() / period);
  return mean;
}

std::vector<Complex> lines_of_period(std::span<const Complex> period, int last) {
  const std::size_t count = period.size();
  std::vector<Complex> roots(count), lines;
  for (std::size_t j = 0; j < count; ++j)
    roots[j] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(count));
  for (int k = -last; k <= last; ++k) {
    Complex sum = 0;
    const std::size_t step = k < 0 ? count - static_cast<std::size_t>(-k) : static_cast<std::size_t>(k);
    for (std::size_t j = 0, root = 0; j < count; ++j, root = (root + step) % count)
      sum += period[j] * roots[root];
    lines.push_back(sum / static_cast<double>(count));
  }
  return lines;
}

}  // namespace rubsweep::scope
