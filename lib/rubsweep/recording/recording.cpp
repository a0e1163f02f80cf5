#include "rubsweep/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/findings.hpp"
#include "rubsweep/recording/turns.hpp"
#include "rubsweep/recording/unit.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;

const Channel& find(const Channels& channels, const std::string& column, const std::string& name) {
  std::string names;
  for (const Channel& channel : channels.channels) {
    if (channel.name == column) return channel;
    names += (names.empty() ? "'" : ", '") + channel.name + '\'';
  }
  throw ConfigError(fmt::format("{}: has no column '{}', allowed: {}", name, column, names));
}

/// Instants of the samples: the first one and how many there are a second.
struct Clock {
  double first_s = 0, rate_hz = 0;
};

/// Most that an instant may be off its place, in steps: instruments write times with few digits.
constexpr double largest_jitter = 0.5;

Clock clock_of(const Channels& channels, const Instrument& instrument, const std::string& name) {
  if (!instrument.time) return {0, instrument.sampling_rate_hz.value()};
  const Channel& time = find(channels, *instrument.time, name);
  const double unit_s = seconds_per(time.unit, time.name, name);
  const std::size_t last = time.values.size() - 1;
  std::vector<double> steps;
  for (std::size_t k = 1; k <= last; ++k) steps.push_back(time.values[k] - time.values[k - 1]);
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  const double usual = steps[steps.size() / 2];
  for (std::size_t k = 1; k <= last; ++k) {
    const double step = time.values[k] - time.values[k - 1];
    if (!(std::abs(step - usual) < largest_jitter * usual)) {
      throw ConfigError(
          fmt::format("{}:{}: '{}' goes from {:.10g} to {:.10g}, allowed: a step of {:.4g} as elsewhere",
                      name, channels.line[k], time.name, time.values[k - 1], time.values[k], usual));
    }
  }
  const double span_s = unit_s * (time.values[last] - time.values[0]);
  return {unit_s * time.values[0], static_cast<double>(last) / span_s};
}

/// Readings in metres.
std::vector<double> readings_m(const Channel& channel, const Probe& probe, const std::string& name) {
  const double scale = metres_per(channel.unit, channel.name, probe.gain_mv_per_um, name);
  std::vector<double> readings = channel.values;
  for (double& value : readings) value *= scale;
  return readings;
}

/// Begins of turns within the samples.
std::vector<double> turn_begins_s(const Channels& channels, const Instrument& instrument, const Clock& clock,
                                  const std::string& name) {
  const std::size_t count = channels.line.size();
  const double last_s = clock.first_s + static_cast<double>(count - 1) / clock.rate_hz;
  if (!instrument.keyphasor) return steady_turns_s(clock.first_s, last_s, instrument.speed_hz.value());
  const Keyphasor& keyphasor = *instrument.keyphasor;
  const Channel& channel = find(channels, keyphasor.column, name);
  std::vector<double> t_s(count);
  for (std::size_t k = 0; k < count; ++k) t_s[k] = clock.first_s + static_cast<double>(k) / clock.rate_hz;
  try {
    const double threshold = keyphasor.threshold ? *keyphasor.threshold : middle_threshold(channel.values);
    return mark_times_s(t_s, channel.values, keyphasor.mark, threshold, keyphasor.hysteresis);
  } catch (const ConfigError& error) {
    throw ConfigError(fmt::format("{}: '{}': {}", name, channel.name, error.what()));
  }
}

/// Turns that begin and end between from_s and to_s.
void keep_stretch(std::vector<double>& begins_s, const Instrument& instrument) {
  std::erase_if(begins_s, [&](double begin_s) {
    return begin_s < instrument.from_s.value_or(begin_s) || begin_s > instrument.to_s.value_or(begin_s);
  });
}

/// x + iy of two readings along two directions.
Complex plane_of(double first, double second, double first_rad, double second_rad) {
  const double determinant = std::sin(second_rad - first_rad);
  return {(first * std::sin(second_rad) - second * std::sin(first_rad)) / determinant,
          (second * std::cos(first_rad) - first * std::cos(second_rad)) / determinant};
}

/// Keeps the longest stretch of turns without a gap; true where something was left out.
bool keep_longest_without_gap(Recording& recording) {
  const auto turns = static_cast<std::size_t>(recording.turns());
  const auto whole = [&](std::size_t turn) {
    const auto samples =
        std::span(recording.displacement_m).subspan(turn * samples_per_revolution, samples_per_revolution);
    return std::ranges::all_of(samples, [](Complex z) { return std::isfinite(z.real() + z.imag()); });
  };
  std::size_t begin = 0, best_begin = 0, best = 0;
  for (std::size_t turn = 0; turn < turns; ++turn) {
    if (!whole(turn)) {
      begin = turn + 1;
    } else if (turn + 1 - begin > best) {
      best = turn + 1 - begin;
      best_begin = begin;
    }
  }
  if (best == turns) return false;
  const auto at = [](auto& values, std::size_t place) {
    return values.begin() + static_cast<std::ptrdiff_t>(place);
  };
  recording.displacement_m = {at(recording.displacement_m, best_begin * samples_per_revolution),
                              at(recording.displacement_m, (best_begin + best) * samples_per_revolution)};
  recording.turn_begin_s = {at(recording.turn_begin_s, best_begin),
                            at(recording.turn_begin_s, best_begin + best + 1)};
  return true;
}

}  // namespace

Recording make_recording(const Channels& channels, const Instrument& instrument, const std::string& name) {
  const Clock clock = clock_of(channels, instrument, name);
  Recording recording{.sampling_rate_hz = clock.rate_hz,
                      .turn_begin_s = turn_begins_s(channels, instrument, clock, name),
                      .plane = instrument.probes.size() == 2};
  keep_stretch(recording.turn_begin_s, instrument);
  if (recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} whole turns of the shaft, allowed: {} or more", name,
                                  std::max(recording.turns(), 0), fewest_turns));
  }
  std::vector<std::vector<double>> turned;
  for (const Probe& probe : instrument.probes) {
    const Channel& channel = find(channels, probe.column, name);
    const std::vector<double> readings = readings_m(channel, probe, name);
    add_findings(readings, channel.name, channels.line, recording.findings);
    turned.push_back(at_equal_angles(readings, clock.first_s, clock.rate_hz, recording.turn_begin_s,
                                     samples_per_revolution));
  }
  const auto direction = [&](std::size_t i) {
    return instrument.probes[i].angle_deg * std::numbers::pi / 180;
  };
  for (std::size_t k = 0; k < turned[0].size(); ++k) {
    recording.displacement_m.push_back(
        recording.plane ? plane_of(turned[0][k], turned[1][k], direction(0), direction(1)) : turned[0][k]);
  }
  if (keep_longest_without_gap(recording) && recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} turns without a gap, allowed: {} or more", name,
                                  recording.turns(), fewest_turns));
  }
  add_speed_findings(recording.turn_begin_s, clock.rate_hz, recording.findings);
  return recording;
}

}  // namespace rubsweep::recording
