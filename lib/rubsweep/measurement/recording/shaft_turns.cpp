#include "rubsweep/measurement/recording/shaft_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/findings.hpp"
#include "rubsweep/measurement/recording/mark_fit.hpp"
#include "rubsweep/measurement/recording/turn_marks.hpp"

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

void refuse_threshold_outside(std::span<const double> signal, double threshold) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : signal) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  if (threshold > low && threshold < high) return;
  throw ConfigError(
      fmt::format("keyphasor.threshold: is {:.4g}, allowed: between {:.4g} and {:.4g}, the signal's "
                  "lowest and highest value",
                  threshold, low, high));
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

ShaftTurns turns_of(const Channels& channels, const Instrument& instrument, const SampleClock& clock,
                    const std::string& name, std::vector<std::string>& findings) {
  const std::size_t count = channels.rows();
  const double last_s = clock.first_s + static_cast<double>(count - 1) / clock.rate_hz;
  if (!instrument.keyphasor && *instrument.speed_hz > clock.rate_hz / 2)
    throw ConfigError(
        name + ": has fewer than two readings a turn at speed_hz, allowed: up to half the sampling rate");
  if (!instrument.keyphasor)
    return {.begin_s = steady_turns_s(clock.first_s, last_s, instrument.speed_hz.value())};
  const Keyphasor& keyphasor = *instrument.keyphasor;
  const Channel& channel = find_channel(channels, keyphasor.column, name);
  std::vector<double> t_s(count);
  for (std::size_t k = 0; k < count; ++k) t_s[k] = clock.first_s + static_cast<double>(k) / clock.rate_hz;
  try {
    const double threshold = keyphasor.threshold ? *keyphasor.threshold : middle_threshold(channel.values);
    refuse_threshold_outside(channel.values, threshold);
    const TurnMarks marks =
        numbered_marks(mark_times_s(t_s, channel.values, keyphasor.mark, threshold, keyphasor.hysteresis),
                       1 / clock.rate_hz);
    add_mark_findings(marks, channel.name, findings);
    const double resolution_s = mark_resolution(channel.values, keyphasor.mark, threshold) / clock.rate_hz;
    SmoothMarks smooth = smoothed_marks(marks.t_s, resolution_s);
    return {std::move(smooth.t_s), marks.t_s, smoothing_bound * resolution_s, smooth.degree};
  } catch (const ConfigError& error) {
    throw ConfigError(fmt::format("{}: '{}': {}", name, channel.name, error.what()));
  }
}

AngleDoubt doubt_without_marks(std::size_t turns) {
  constexpr double room_turns = 0.1;
  constexpr std::size_t most_degree = 3, turns_a_degree = 8;
  const std::size_t degree = std::min(most_degree, turns / turns_a_degree);
  if (degree == 0) return {};
  return {std::vector<double>(turns + 1, -room_turns), std::vector<double>(turns + 1, room_turns),
          static_cast<int>(degree)};
}

AngleDoubt angle_doubt_of(std::span<const double> turn_begin_s, const ShaftTurns& all) {
  AngleDoubt doubt{.degree = all.degree};
  if (all.degree == 0) return doubt;
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(all.begin_s, turn_begin_s.front()) -
                                              all.begin_s.begin());
  const double speed_hz =
      static_cast<double>(turn_begin_s.size() - 1) / (turn_begin_s.back() - turn_begin_s.front());
  for (std::size_t k = 0; k < turn_begin_s.size(); ++k) {
    const double off_s = all.mark_s[first + k] - turn_begin_s[k];
    doubt.low_turns.push_back(std::min((off_s - all.room_s) * speed_hz, 0.0));
    doubt.high_turns.push_back(std::max((off_s + all.room_s) * speed_hz, 0.0));
  }
  return doubt;
}

}  // namespace rubsweep::recording
