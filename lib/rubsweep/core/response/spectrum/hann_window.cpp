#include "rubsweep/core/response/spectrum/hann_window.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;

double weight(std::size_t k, std::size_t count) {
  return 1 - std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
}

Complex weighted_mean(std::span<const Complex> samples) {
  Complex sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) sum += weight(k, samples.size()) * samples[k];
  return sum / static_cast<double>(samples.size());
}

std::vector<Complex> weighted_about(std::span<const Complex> samples, Complex mean) {
  std::vector<Complex> weighted;
  weighted.reserve(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k)
    weighted.push_back(weight(k, samples.size()) * (samples[k] - mean));
  return weighted;
}

}  // namespace

std::vector<Complex> under_hann_window(std::span<const Complex> samples) {
  const Complex sum = std::accumulate(samples.begin(), samples.end(), Complex{});
  return weighted_about(samples, sum / static_cast<double>(samples.size()));
}

std::vector<Complex> under_hann_window_of_growing(std::span<const Complex> samples) {
  return weighted_about(samples, weighted_mean(samples));
}

FullSpectrum windowed_spectrum(std::span<const Complex> displacement_m, int turns,
                               SpectrumWorkspace& workspace) {
  FullSpectrum spectrum = full_spectrum(under_hann_window_of_growing(displacement_m), turns, workspace);
  spectrum.amplitude_m[static_cast<std::size_t>(-spectrum.first_line())] =
      std::abs(weighted_mean(displacement_m));
  return spectrum;
}

}  // namespace rubsweep::response::spectrum
