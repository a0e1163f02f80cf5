#include "rubsweep/measurement/recording/run_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {

std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_turn, bool vector) {
  const auto length = static_cast<std::size_t>(samples_per_turn);
  std::vector<std::complex<double>> mean(length);
  double turns = 0;
  for (std::size_t begin = 0; begin + length <= displacement_m.size(); begin += length) {
    const auto turn = displacement_m.subspan(begin, length);
    if (!std::ranges::all_of(turn, [](auto z) { return std::isfinite(z.real() + z.imag()); })) continue;
    for (std::size_t k = 0; k < length; ++k) mean[k] += turn[k];
    ++turns;
  }
  if (turns == 0) throw ConfigError("run_out: every turn has a gap");
  for (std::complex<double>& z : mean) z /= turns;
  const auto turned = [&](std::size_t k, int order) {
    return std::polar(1.0, order * (2 * std::numbers::pi * static_cast<double>(k) / samples_per_turn));
  };
  const auto component = [&](int order) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < length; ++k) sum += mean[k] * turned(k, -order) / static_cast<double>(length);
    return sum;
  };
  const std::complex<double> gap = component(0), forward = component(1), backward = component(-1);
  for (std::size_t k = 0; k < length; ++k)
    mean[k] = vector ? forward * turned(k, 1) + backward * turned(k, -1) : mean[k] - gap;
  return mean;
}

void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m) {
  for (std::size_t k = 0; k < displacement_m.size(); ++k)
    displacement_m[k] -= run_out_m[k % run_out_m.size()];
}

}  // namespace rubsweep::recording
