#include "rubsweep/measurement/recording/turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubsweep::recording {
namespace {

/// Polynomial through up to `most` neighbouring values, those about `place`, which counts values from 0;
/// Lagrange.
double between(std::span<const double> values, double place, std::ptrdiff_t most) {
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t count = std::min(most, size);
  const std::ptrdiff_t first = std::clamp(static_cast<std::ptrdiff_t>(std::floor(place)) - count / 2 + 1,
                                          std::ptrdiff_t{0}, size - count);
  double sum = 0;
  for (std::ptrdiff_t i = first; i < first + count; ++i) {
    double weight = 1;
    for (std::ptrdiff_t j = first; j < first + count; ++j) {
      if (j != i) weight *= (place - static_cast<double>(j)) / static_cast<double>(i - j);
    }
    sum += weight * values[static_cast<std::size_t>(i)];
  }
  return sum;
}

}  // namespace

std::vector<double> steady_turns_s(double from_s, double to_s, double speed_hz) {
  std::vector<double> begins_s;
  const auto turns = static_cast<long>(std::floor((to_s - from_s) * speed_hz * (1 + 1e-12)));
  for (long turn = 0; turn <= turns; ++turn)
    begins_s.push_back(std::min(to_s, from_s + static_cast<double>(turn) / speed_hz));
  return begins_s;
}

std::vector<double> turn_speeds_hz(std::span<const double> turn_begin_s) {
  std::vector<double> speeds_hz;
  for (std::size_t k = 1; k < turn_begin_s.size(); ++k)
    speeds_hz.push_back(1 / (turn_begin_s[k] - turn_begin_s[k - 1]));
  return speeds_hz;
}

std::vector<double> at_equal_angles(std::span<const double> signal, double first_s, double sampling_rate_hz,
                                    std::span<const double> turn_begin_s, int samples_per_revolution) {
  constexpr std::ptrdiff_t marks = 4, neighbours = 6;
  std::vector<double> samples;
  for (std::size_t turn = 0; turn + 1 < turn_begin_s.size(); ++turn) {
    for (int k = 0; k < samples_per_revolution; ++k) {
      const double turns = static_cast<double>(turn) + static_cast<double>(k) / samples_per_revolution;
      const double t_s = between(turn_begin_s, turns, marks);
      samples.push_back(between(signal, (t_s - first_s) * sampling_rate_hz, neighbours));
    }
  }
  return samples;
}

}  // namespace rubsweep::recording
