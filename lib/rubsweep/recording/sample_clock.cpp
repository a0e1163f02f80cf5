#include "rubsweep/recording/sample_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/unit.hpp"

namespace rubsweep::recording {
namespace {

/// Most that an instant may be off its place, in steps: instruments write times with few digits.
constexpr double largest_jitter = 0.5;

/// File and row, for messages.
std::string place_of(const Channels& channels, std::size_t row, const std::string& name) {
  return channels.line.empty() ? fmt::format("{}: {}", name, channels.place_of(row))
                               : fmt::format("{}:{}", name, channels.line[row]);
}

SampleClock column_clock(const Channels& channels, const Instrument& instrument, const std::string& name) {
  if (!instrument.time) {
    const auto rate_hz =
        instrument.sampling_rate_hz ? instrument.sampling_rate_hz : channels.sampling_rate_hz;
    if (!rate_hz)
      throw ConfigError(name + ": says no times, allowed: with time or sampling_rate_hz in its description");
    return {0, *rate_hz};
  }
  const Channel& time = find_channel(channels, *instrument.time, name);
  const double unit_s = seconds_per(time.unit, time.name, name);
  const std::size_t last = time.values.size() - 1;
  std::vector<double> steps;
  for (std::size_t k = 1; k <= last; ++k) steps.push_back(time.values[k] - time.values[k - 1]);
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  const double usual = steps[steps.size() / 2];
  if (!(usual > 0)) {
    const auto k = static_cast<std::size_t>(std::ranges::adjacent_find(time.values, std::greater_equal<>()) -
                                            time.values.begin() + 1);
    throw ConfigError(
        fmt::format("{}: '{}' does not rise from {:.10g} to {:.10g}, allowed: times one after the other",
                    place_of(channels, k, name), time.name, time.values[k - 1], time.values[k]));
  }
  for (std::size_t k = 1; k <= last; ++k) {
    const double step = time.values[k] - time.values[k - 1];
    if (!(std::abs(step - usual) < largest_jitter * usual)) {
      throw ConfigError(
          fmt::format("{}: '{}' goes from {:.10g} to {:.10g}, allowed: a step of {:.4g} as elsewhere",
                      place_of(channels, k, name), time.name, time.values[k - 1], time.values[k], usual));
    }
  }
  const double mean = (time.values[last] - time.values[0]) / static_cast<double>(last);
  for (std::size_t k = 1; k <= last; ++k) {
    const double off = time.values[k] - time.values[0] - mean * static_cast<double>(k);
    if (std::abs(off) > largest_jitter * mean)
      throw ConfigError(
          fmt::format("{}: '{}' has {:.10g} {:.3g} steps off its place, allowed: an even sampling rate",
                      place_of(channels, k, name), time.name, time.values[k], off / mean));
  }
  const double span_s = unit_s * (time.values[last] - time.values[0]);
  return {unit_s * time.values[0], static_cast<double>(last) / span_s};
}

void refuse_stretch_outside(const Channels& channels, const Instrument& instrument, const SampleClock& clock,
                            const std::string& name) {
  const double last_s = clock.first_s + static_cast<double>(channels.rows() - 1) / clock.rate_hz;
  if (instrument.from_s.value_or(clock.first_s) < last_s && instrument.to_s.value_or(last_s) > clock.first_s)
    return;
  throw ConfigError(
      fmt::format("{}: lasts from {:.4g} to {:.4g} s, allowed: from_s and to_s that leave some of it", name,
                  clock.first_s, last_s));
}

}  // namespace

const Channel& find_channel(const Channels& channels, const std::string& column, const std::string& name) {
  std::string names;
  const Channel* found = nullptr;
  for (const Channel& channel : channels.channels) {
    if (channel.name == column && found)
      throw ConfigError(fmt::format("{}: has two columns '{}', allowed: names that differ", name, column));
    if (channel.name == column) found = &channel;
    names += (names.empty() ? "'" : ", '") + channel.name + '\'';
  }
  if (found) return *found;
  throw ConfigError(
      fmt::format("{}: has no column '{}'{}, allowed: {}", name, column, channels.left_out_text(), names));
}

SampleClock clock_of(const Channels& channels, const Instrument& instrument, const std::string& name) {
  const SampleClock clock = column_clock(channels, instrument, name);
  refuse_stretch_outside(channels, instrument, clock, name);
  return clock;
}

}  // namespace rubsweep::recording
