#include "rubsweep/analysis/page/encode_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rubsweep/analysis/page/compressed.hpp"

namespace rubsweep::page {
namespace {

struct Miss {
  std::size_t place = 0;
  double distance = 0;
};

/// The sample between `first` and `last` that the straight line between them misses most.
Miss largest_miss(std::span<const std::vector<double>> signals, std::size_t first, std::size_t last) {
  Miss worst;
  for (std::size_t k = first + 1; k < last; ++k) {
    const double share = static_cast<double>(k - first) / static_cast<double>(last - first);
    for (const std::vector<double>& signal : signals) {
      const double line = signal[first] + share * (signal[last] - signal[first]);
      const double distance = std::abs(signal[k] - line);
      if (distance > worst.distance) worst = {k, distance};
    }
  }
  return worst;
}

double extent(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Samples on either side of a change of sign of some gap.
std::vector<std::size_t> changes_of_contact(const SettledOrbit& orbit) {
  std::vector<std::size_t> places;
  for (std::size_t k = 1; k < orbit.signals.front().size(); ++k) {
    bool changes = false;
    for (std::size_t i = 4; i < orbit.signals.size(); i += 3)
      changes = changes || (orbit.signals[i][k - 1] < 0) != (orbit.signals[i][k] < 0);
    if (!changes) continue;
    if (places.empty() || places.back() != k - 1) places.push_back(k - 1);
    places.push_back(k);
  }
  return places;
}

void append_gaps(std::string& bytes, std::span<const std::size_t> places) {
  std::string gaps;
  for (std::size_t i = 0; i < places.size(); ++i)
    append(gaps, static_cast<std::uint16_t>(i == 0 ? places[0] : places[i] - places[i - 1]));
  append_planes(bytes, gaps, 2);
}

void append_signals(std::string& bytes, const SettledOrbit& orbit) {
  const double tolerance = drawing_tolerance * std::max(extent(orbit.signals[0]), extent(orbit.signals[1]));
  const std::vector<std::size_t> places = needed_samples(orbit.signals, tolerance, changes_of_contact(orbit));
  append(bytes, static_cast<std::uint16_t>(places.size()));
  append(bytes, static_cast<std::uint16_t>(orbit.signals.size()));
  append_gaps(bytes, places);
  for (const std::vector<double>& signal : orbit.signals) {
    std::vector<double> kept;
    for (const std::size_t place : places) kept.push_back(signal[place]);
    append_levels(bytes, kept);
  }
}

void append_section(std::string& bytes, const SettledOrbit& orbit) {
  std::vector<double> x, y;
  for (const std::complex<double>& point : orbit.section_m) {
    x.push_back(point.real());
    y.push_back(point.imag());
  }
  append(bytes, static_cast<std::uint16_t>(x.size()));
  append_levels(bytes, x);
  append_levels(bytes, y);
}

void append_spectrum(std::string& bytes, const response::spectrum::FullSpectrum& spectrum) {
  const int reach = static_cast<int>(highest_order * spectrum.turns);
  const int first = std::max(spectrum.first_line(), -reach), last = std::min(spectrum.last_line(), reach);
  double largest = 0;
  for (int k = first; k <= last; ++k) largest = std::max(largest, spectrum.amplitude(k));
  std::string lines, amplitudes;
  std::uint16_t count = 0;
  for (int k = first; k <= last; ++k) {
    if (largest == 0 || spectrum.amplitude(k) < smallest_line * largest) continue;
    ++count;
    append(lines, static_cast<std::uint16_t>(k));
    append(amplitudes, static_cast<std::uint16_t>(std::lround(65535 * spectrum.amplitude(k) / largest)));
  }
  append(bytes, static_cast<std::uint16_t>(spectrum.turns));
  append(bytes, count);
  append(bytes, static_cast<float>(largest));
  bytes += lines + amplitudes;
}

}  // namespace

std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always) {
  const std::size_t end = signals.front().size() - 1;
  std::vector<std::size_t> places{0};
  for (const std::size_t place : always)
    if (place > places.back() && place < end) places.push_back(place);
  places.push_back(end);

  std::vector<std::pair<std::size_t, std::size_t>> waiting;
  for (std::size_t i = 1; i < places.size(); ++i) waiting.emplace_back(places[i - 1], places[i]);
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    const Miss miss = largest_miss(signals, first, last);
    if (miss.distance <= tolerance) continue;
    places.push_back(miss.place);
    waiting.emplace_back(first, miss.place);
    waiting.emplace_back(miss.place, last);
  }
  std::sort(places.begin(), places.end());
  return places;
}

void append_levels(std::string& bytes, std::span<const double> values) {
  const double low = values.empty() ? 0 : *std::min_element(values.begin(), values.end());
  // Levels are counted in the numbers that are written, so that rounding those costs nothing.
  const auto base = static_cast<float>(low);
  const auto width = static_cast<float>(values.empty() ? 0 : extent(values) / levels);
  append(bytes, base);
  append(bytes, width);
  std::string differences;
  long before = 0;
  for (const double value : values) {
    const long level =
        width > 0 ? std::lround((value - static_cast<double>(base)) / static_cast<double>(width)) : 0;
    append(differences, static_cast<std::uint16_t>(level - before));
    before = level;
  }
  append_planes(bytes, differences, 2);
}

std::string encode_orbit(std::size_t cell, const SettledOrbit& orbit) {
  std::string body;
  append(body, static_cast<std::uint32_t>(orbit.first_revolution));
  append(body, static_cast<std::uint16_t>(orbit.turns));
  append(body, static_cast<std::uint16_t>(orbit.steps_per_turn));
  append_signals(body, orbit);
  append_section(body, orbit);
  append_spectrum(body, orbit.spectrum);
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(cell));
  append(bytes, static_cast<std::uint32_t>(body.size()));
  return bytes + body;
}

}  // namespace rubsweep::page
