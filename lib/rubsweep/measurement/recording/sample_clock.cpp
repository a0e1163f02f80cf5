#include "rubsweep/measurement/recording/sample_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

/// Largest deviation of an instant from even spacing, in steps: instruments write times with few digits.
constexpr double largest_jitter = 0.5;

/// File and row, as they appear in messages.
std::string place_of(const Channels& channels, std::size_t row, const std::string& name) {
  return channels.line.empty() ? fmt::format("{}: {}", name, channels.place_of(row))
                               : fmt::format("{}:{}", name, channels.line[row]);
}

/// "column 3", whatever its name.
const Channel* by_number(const Channels& channels, std::string_view column) {
  constexpr std::string_view word = "column ";
  std::size_t number = 0;
  if (!column.starts_with(word)) return nullptr;
  const char* const end = column.data() + column.size();
  if (std::from_chars(column.data() + word.size(), end, number).ptr != end) return nullptr;
  for (std::size_t i = 0; i < channels.channels.size(); ++i) {
    const std::size_t own = channels.channels[i].number;
    if ((own > 0 ? own : i + 1) == number) return &channels.channels[i];
  }
  return nullptr;
}

/// Median of the steps.
double usual_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < times.size(); ++k) steps.push_back(times[k] - times[k - 1]);
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  return steps[steps.size() / 2];
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
  const double usual = usual_step(time.values);
  if (!(usual > 0)) {
    const auto k = static_cast<std::size_t>(
        std::ranges::adjacent_find(time.values, [](double a, double b) { return !(b > a); }) -
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
  if (const Channel* numbered = by_number(channels, column)) return *numbered;
  throw ConfigError(
      fmt::format("{}: has no column '{}'{}, allowed: {}", name, column, channels.left_out_text(), names));
}

SampleClock clock_of(const Channels& channels, const Instrument& instrument, const std::string& name) {
  const SampleClock clock = column_clock(channels, instrument, name);
  refuse_stretch_outside(channels, instrument, clock, name);
  return clock;
}

std::optional<Channels> stretch_without_jump(const Channels& channels, const Instrument& instrument,
                                             const std::string& name, std::vector<std::string>& findings) {
  if (!instrument.time) return std::nullopt;
  const Channel& time = find_channel(channels, *instrument.time, name);
  const double unit_s = seconds_per(time.unit, time.name, name), usual = usual_step(time.values);
  std::vector<std::size_t> begins{0};  // first samples of the stretches, and the end of the last one
  for (std::size_t k = 1; k < time.values.size(); ++k) {
    const double step = time.values[k] - time.values[k - 1];
    if (!(usual > 0) || step <= (1 - largest_jitter) * usual)
      return std::nullopt;  // the clock is invalid; clock_of reports where
    if (step >= (1 + largest_jitter) * usual) begins.push_back(k);
  }
  const std::size_t jumps = begins.size() - 1;
  constexpr std::size_t usual_steps_of_one = 100;
  if (jumps == 0 || jumps > time.values.size() / usual_steps_of_one) return std::nullopt;
  begins.push_back(time.values.size());
  const auto looked_at = [&](std::size_t stretch) {
    return std::count_if(
        time.values.begin() + static_cast<std::ptrdiff_t>(begins[stretch]),
        time.values.begin() + static_cast<std::ptrdiff_t>(begins[stretch + 1]), [&](double t) {
          const double t_s = unit_s * t;
          return t_s >= instrument.from_s.value_or(t_s) && t_s <= instrument.to_s.value_or(t_s);
        });
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i <= jumps; ++i)
    if (looked_at(i) > looked_at(best)) best = i;
  const auto first = static_cast<std::ptrdiff_t>(begins[best]),
             end = static_cast<std::ptrdiff_t>(begins[best + 1]);
  findings.push_back(
      fmt::format("'{}' jumps from {:.10g} to {:.10g} at {}{}: the longest stretch without a jump, from "
                  "{:.10g} to {:.10g}, is looked at",
                  time.name, time.values[begins[1] - 1], time.values[begins[1]], channels.place_of(begins[1]),
                  jumps > 1 ? fmt::format(", {} times in all", jumps) : "", time.values[begins[best]],
                  time.values[begins[best + 1] - 1]));
  Channels stretch{
      .channels = {}, .sampling_rate_hz = channels.sampling_rate_hz, .left_out = channels.left_out};
  for (const Channel& one : channels.channels)
    stretch.channels.push_back(
        {one.name, one.unit, {one.values.begin() + first, one.values.begin() + end}, one.number});
  if (!channels.line.empty()) stretch.line = {channels.line.begin() + first, channels.line.begin() + end};
  if (end - first < 2)
    throw ConfigError(name + ": has no two readings without a jump in time, allowed: two or more");
  return stretch;
}

}  // namespace rubsweep::recording
