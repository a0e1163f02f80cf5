#include "rubsweep/response/spectrum/comb_line.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;

constexpr int farthest = 16;

double amplitude_at(std::span<const Complex> z, int samples_per_revolution, double order) {
  const double two_pi = 2 * std::numbers::pi, count = static_cast<double>(z.size());
  const Complex back = std::polar(1.0, -two_pi * order / samples_per_revolution);
  const Complex along = std::polar(1.0, two_pi / count);
  Complex line = 1, window = std::polar(1.0, two_pi / (2 * count)), sum = 0;
  for (const Complex& sample : z) {
    sum += (1 - window.real()) * line * sample;
    line *= back;
    window *= along;
  }
  return std::abs(sum) / count;  // the weights 1 - cos have mean 1
}

}  // namespace

std::optional<SpectralLine> largest_comb_line(std::span<const Complex> displacement_m,
                                              int samples_per_revolution, double spacing) {
  const double bin = samples_per_revolution / static_cast<double>(displacement_m.size());
  std::optional<SpectralLine> largest;
  for (int k = -farthest; k <= farthest; ++k) {
    const double order = 1 + k * spacing;
    if (std::abs(order) < bin || std::abs(order) >= samples_per_revolution / 2.0) continue;
    const double amplitude = amplitude_at(displacement_m, samples_per_revolution, order);
    if (amplitude > (largest ? largest->amplitude_m : 0))
      largest = {.order = order, .amplitude_m = amplitude};
  }
  return largest;
}

}  // namespace rubsweep::response::spectrum
