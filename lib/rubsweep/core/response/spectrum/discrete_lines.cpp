#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "rubsweep/core/error.hpp"

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

constexpr double energy_of_the_lines = 0.99;
constexpr int most_lines = 16;
constexpr double most_moved = 0.01;

/// Sums over the width of a line; indices of bins wrap around.
std::vector<double> smoothed(std::span<const double> shares) {
  const std::size_t count = shares.size();
  std::vector<double> sums(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j <= 2 * hann_half_width; ++j) sums[k] += shares[(k + j) % count];
  }
  return sums;
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

std::vector<double> energy_shares(std::span<const Complex> samples, SpectrumWorkspace& workspace) {
  std::vector<double> shares = full_spectrum(under_hann_window(samples), 1, workspace).amplitude_m;
  double energy = 0;
  for (double& share : shares) {
    share *= share;
    energy += share;
  }
  if (energy > 0) {
    for (double& share : shares) share /= energy;
  }
  return shares;
}

int lines_holding(std::span<const double> energy_shares, double share) {
  std::vector<double> left(energy_shares.begin(), energy_shares.end());
  const std::size_t count = left.size();
  const double energy = std::accumulate(left.begin(), left.end(), 0.0);
  int lines = 0;
  for (double held = 0; held < share * energy; ++lines) {
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(left) - left.begin());
    for (std::size_t j = 0; j <= 2 * hann_half_width; ++j) {
      double& bin = left[(peak + count + j - hann_half_width) % count];
      held += bin;
      bin = 0;
    }
  }
  return lines;
}

double moved_share(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size()) {
    throw SolverError(
        fmt::format("spectra of {} and {} bins cannot be compared", first.size(), second.size()));
  }
  const std::vector<double> a = smoothed(first), b = smoothed(second);
  double moved = 0;
  for (std::size_t k = 0; k < a.size(); ++k) moved += std::abs(a[k] - b[k]);
  return moved / (2 * (2 * hann_half_width + 1));
}

bool same_discrete_lines(std::span<const Complex> first, std::span<const Complex> second,
                         SpectrumWorkspace& workspace) {
  const std::vector<double> a = energy_shares(first, workspace), b = energy_shares(second, workspace);
  return lines_holding(a, energy_of_the_lines) <= most_lines &&
         lines_holding(b, energy_of_the_lines) <= most_lines && moved_share(a, b) <= most_moved;
}

}  // namespace rubsweep::response::spectrum
