#include "rubsweep/page/encode_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rubsweep/page/byte_writer.hpp"
#include "rubsweep/page/needed_samples.hpp"

namespace rubsweep::page {
namespace {

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
