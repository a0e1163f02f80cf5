#include "rubsweep/core/response/spectrum/hann_window.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;

double weight(std::size_t k, std::size_t count) {
  return 1 - std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count));
}

/// The mean has the same weights: a line that grows shifts the plain one.
Complex weighted_mean(std::span<const Complex> samples) {
  Complex sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) sum += weight(k, samples.size()) * samples[k];
  return sum / static_cast<double>(samples.size());
}

}  // namespace

std::vector<Complex> under_hann_window(std::span<const Complex> samples) {
  const Complex mean = weighted_mean(samples);
  std::vector<Complex> weighted;
  for (std::size_t k = 0; k < samples.size(); ++k)
    weighted.push_back(weight(k, samples.size()) * (samples[k] - mean));
  return weighted;
}

FullSpectrum windowed_spectrum(std::span<const Complex> displacement_m, int turns,
                               SpectrumWorkspace& workspace) {
  FullSpectrum spectrum = full_spectrum(under_hann_window(displacement_m), turns, workspace);
  spectrum.amplitude_m[static_cast<std::size_t>(-spectrum.first_line())] =
      std::abs(weighted_mean(displacement_m));
  return spectrum;
}

}  // namespace rubsweep::response::spectrum
