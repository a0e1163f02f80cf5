#include "rubsweep/recording/run_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "rubsweep/error.hpp"

namespace rubsweep::recording {

std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_revolution, bool vector) {
  using Complex = std::complex<double>;
  const auto length = static_cast<std::size_t>(samples_per_revolution);
  std::vector<Complex> mean(length);
  double turns = 0;
  for (std::size_t begin = 0; begin + length <= displacement_m.size(); begin += length) {
    const auto turn = displacement_m.subspan(begin, length);
    if (!std::ranges::all_of(turn, [](Complex z) { return std::isfinite(z.real() + z.imag()); })) continue;
    for (std::size_t k = 0; k < length; ++k) mean[k] += turn[k];
    ++turns;
  }
  if (turns == 0) throw ConfigError("run_out: every turn has a gap");
  Complex gap = 0, forward = 0, backward = 0;
  const auto angle = [&](std::size_t k) {
    return 2 * std::numbers::pi * static_cast<double>(k) / samples_per_revolution;
  };
  for (std::size_t k = 0; k < length; ++k) {
    mean[k] /= turns;
    gap += mean[k] / static_cast<double>(length);
    forward += mean[k] * std::polar(1.0, -angle(k)) / static_cast<double>(length);
    backward += mean[k] * std::polar(1.0, angle(k)) / static_cast<double>(length);
  }
  for (std::size_t k = 0; k < length; ++k) {
    mean[k] =
        vector ? forward * std::polar(1.0, angle(k)) + backward * std::polar(1.0, -angle(k)) : mean[k] - gap;
  }
  return mean;
}

void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m) {
  for (std::size_t k = 0; k < displacement_m.size(); ++k)
    displacement_m[k] -= run_out_m[k % run_out_m.size()];
}

}  // namespace rubsweep::recording
