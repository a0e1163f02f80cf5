#include "rubsweep/core/response/spectrum/resolved_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>

#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// Weights of a Hann window with mean 1.
std::vector<double> hann_window(std::size_t count) {
  std::vector<double> weights(count);
  for (std::size_t k = 0; k < count; ++k)
    weights[k] = 1 - std::cos(2 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
  return weights;
}

/// Weighted component at a frequency, with its phase at the first sample.
Complex component(std::span<const Complex> samples, std::span<const double> weights, double frequency) {
  const Complex step = std::polar(1.0, -2 * pi * frequency);
  Complex sum = 0, turn = 1;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    // A product of many steps would drift, so the phase is set anew.
    if (k % 64 == 0) turn = std::polar(1.0, -2 * pi * frequency * static_cast<double>(k));
    sum += weights[k] * samples[k] * turn;
    turn *= step;
  }
  return sum / static_cast<double>(samples.size());
}

void add(std::span<Complex> samples, double frequency, Complex amplitude) {
  const Complex step = std::polar(1.0, 2 * pi * frequency);
  Complex turn = 1;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (k % 64 == 0) turn = std::polar(1.0, 2 * pi * frequency * static_cast<double>(k));
    samples[k] += amplitude * turn;
    turn *= step;
  }
}

/// Frequency near a guess at which the component is largest, by parabolas through three logarithms.
double peak_near(std::span<const Complex> samples, std::span<const double> weights, double frequency) {
  constexpr int rounds = 8;
  double step = 0.25 / static_cast<double>(samples.size());
  const double small = step / 256;
  for (int round = 0; round < rounds && step > small; ++round) {
    const auto height = [&](double place) { return std::log(std::norm(component(samples, weights, place))); };
    const double left = height(frequency - step), middle = height(frequency),
                 right = height(frequency + step);
    const double bend = left - 2 * middle + right;
    if (!(bend < 0)) return frequency;
    const double moved = std::clamp((left - right) / (2 * bend), -1.0, 1.0);
    frequency += step * moved;
    if (std::abs(moved) < 0.5) step /= 8;
  }
  return frequency;
}

/// Amplitudes of the bins under a Hann window.
struct Bins {
  std::vector<double> amplitude;

  double frequency(std::size_t bin) const {
    const auto count = static_cast<double>(amplitude.size()), place = static_cast<double>(bin) / count;
    return place < 0.5 ? place : place - 1;
  }
};

Bins bins_of(std::span<const Complex> samples, std::span<const double> weights,
             SpectrumWorkspace& workspace) {
  std::vector<Complex> windowed(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) windowed[k] = weights[k] * samples[k];
  Bins bins;
  for (const Complex line : transform(windowed, workspace))
    bins.amplitude.push_back(std::abs(line) / static_cast<double>(samples.size()));
  return bins;
}

/// Whether a frequency is under the peak of a known line.
bool is_covered(double frequency, std::span<const ResolvedLine> known, std::size_t bins) {
  return std::ranges::any_of(known, [&](const ResolvedLine& line) {
    return std::abs(std::remainder(frequency - line.frequency, 1.0)) * static_cast<double>(bins) <
           hann_half_width;
  });
}

/// Root mean square, of each component, of the bins near a frequency that no line covers. (In bins where
/// lines were subtracted, part of the noise is missing.)
double noise_near(const Bins& rest, double frequency, std::span<const ResolvedLine> known) {
  constexpr std::size_t enough = 16;
  const std::size_t count = rest.amplitude.size();
  const auto middle = static_cast<long>(std::floor(frequency * static_cast<double>(count)));
  double sum = 0;
  std::size_t found = 0;
  for (long k = 0; k < static_cast<long>(count) && found < enough; ++k) {
    const long place = middle + (k % 2 == 0 ? -k / 2 : k / 2 + 1), size = static_cast<long>(count);
    const auto bin = static_cast<std::size_t>(((place % size) + size) % size);
    if (is_covered(rest.frequency(bin), known, count)) continue;
    sum += rest.amplitude[bin] * rest.amplitude[bin];
    ++found;
  }
  return found > 0 ? std::sqrt(sum / (2 * static_cast<double>(found))) : 0;
}

/// Frequency of the largest bin in the range of the search that no known line covers.
std::optional<double> largest_frequency(const Bins& bins, const LineSearch& search,
                                        std::span<const ResolvedLine> known) {
  std::optional<std::size_t> largest;
  for (std::size_t k = 0; k < bins.amplitude.size(); ++k) {
    const double frequency = bins.frequency(k);
    if (frequency < search.lowest || frequency > search.highest) continue;
    if (is_covered(frequency, known, bins.amplitude.size())) continue;
    if (!largest || bins.amplitude[k] > bins.amplitude[*largest]) largest = k;
  }
  if (!largest || !(bins.amplitude[*largest] > search.least_amplitude)) return std::nullopt;
  return bins.frequency(*largest);
}

/// Estimates each line again, with all others removed from `left`, until none of them moves.
void refine(std::vector<ResolvedLine>& lines, std::span<Complex> left, std::span<const double> weights,
            bool about_mean, int most_rounds) {
  constexpr double small_bins = 1e-4;
  bool moved = lines.size() > 1;
  for (int round = 0; round < most_rounds && moved; ++round) {
    moved = false;
    for (ResolvedLine& line : lines) {
      const double before = line.frequency;
      add(left, before, line.amplitude);
      if (!(about_mean && &line == lines.data())) line.frequency = peak_near(left, weights, before);
      line.amplitude = component(left, weights, line.frequency);
      add(left, line.frequency, -line.amplitude);
      moved = moved || std::abs(line.frequency - before) * static_cast<double>(left.size()) > small_bins;
    }
  }
}

/// Sets the uncertainties from the noise and from the difference between both halves of the samples.
void add_uncertainties(std::vector<ResolvedLine>& lines, std::span<Complex> left, const Bins& rest) {
  const std::size_t half = left.size() / 2;
  const auto count = static_cast<double>(left.size());
  const std::vector<double> weights = hann_window(half), even(left.size(), 1.0);
  const auto beyond = [](double difference, double noise) {
    return std::max(0.0, difference * difference / 4 - noise * noise);
  };
  for (ResolvedLine& line : lines) {
    // A Hann window determines a frequency to 0.6 noise / (amplitude length); half of the samples determine
    // it to 2.8 times that.
    const double noise = noise_near(rest, line.frequency, lines), size = std::abs(line.amplitude);
    const double frequency_noise = 0.6 * noise / (size * count);
    add(left, line.frequency, line.amplitude);
    const auto first = left.first(half), last = left.last(half);
    const double f = peak_near(first, weights, line.frequency), g = peak_near(last, weights, line.frequency);
    const double a = std::abs(component(first, weights, f)), b = std::abs(component(last, weights, g));
    const double mean = std::abs(component(left, even, line.frequency));
    add(left, line.frequency, -line.amplitude);
    line.amplitude_uncertainty =
        std::sqrt(noise * noise + std::max(beyond(a - b, noise), beyond(2 * (mean - size), noise)));
    line.frequency_uncertainty =
        std::sqrt(frequency_noise * frequency_noise + beyond(f - g, 2 * frequency_noise));
  }
}

}  // namespace

std::vector<ResolvedLine> resolve_lines(std::span<const Complex> samples, const LineSearch& search,
                                        SpectrumWorkspace& workspace) {
  constexpr int rounds = 2, last_rounds = 12;
  std::vector<Complex> left(samples.begin(), samples.end());
  const std::vector<double> weights = hann_window(left.size());
  std::vector<ResolvedLine> lines;
  // The mean is a line of frequency 0.
  if (search.about_mean) {
    lines.push_back({.amplitude = component(left, weights, 0)});
    add(left, 0, -lines.front().amplitude);
  }
  const std::size_t most_lines = lines.size() + static_cast<std::size_t>(search.most_lines);
  while (lines.size() < most_lines) {
    const auto frequency = largest_frequency(bins_of(left, weights, workspace), search, lines);
    if (!frequency) break;
    const double place = peak_near(left, weights, *frequency);
    lines.push_back({.frequency = place, .amplitude = component(left, weights, place)});
    add(left, place, -lines.back().amplitude);
    refine(lines, left, weights, search.about_mean, rounds);
  }
  refine(lines, left, weights, search.about_mean, last_rounds);
  add_uncertainties(lines, left, bins_of(left, weights, workspace));
  if (search.about_mean) lines.erase(lines.begin());
  std::ranges::sort(lines, std::greater{}, [](const ResolvedLine& line) { return std::abs(line.amplitude); });
  return lines;
}

}  // namespace rubsweep::response::spectrum
