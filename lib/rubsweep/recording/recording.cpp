#include "rubsweep/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/findings.hpp"
#include "rubsweep/recording/mark_fit.hpp"
#include "rubsweep/recording/run_out.hpp"
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
  if (!instrument.time) {
    const auto rate_hz =
        instrument.sampling_rate_hz ? instrument.sampling_rate_hz : channels.sampling_rate_hz;
    if (!rate_hz)
      throw ConfigError(name + ": says no times, allowed: with time or sampling_rate_hz in its description");
    return {0, *rate_hz};
  }
  const Channel& time = find(channels, *instrument.time, name);
  const auto place = [&](std::size_t row) {
    return channels.line.empty() ? fmt::format("{}: {}", name, channels.place_of(row))
                                 : fmt::format("{}:{}", name, channels.line[row]);
  };
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
          fmt::format("{}: '{}' goes from {:.10g} to {:.10g}, allowed: a step of {:.4g} as elsewhere",
                      place(k), time.name, time.values[k - 1], time.values[k], usual));
    }
  }
  const double mean = (time.values[last] - time.values[0]) / static_cast<double>(last);
  for (std::size_t k = 1; k <= last; ++k) {
    const double off = time.values[k] - time.values[0] - mean * static_cast<double>(k);
    if (std::abs(off) > largest_jitter * mean)
      throw ConfigError(
          fmt::format("{}: '{}' has {:.10g} {:.3g} steps off its place, allowed: an even sampling rate",
                      place(k), time.name, time.values[k], off / mean));
  }
  const double span_s = unit_s * (time.values[last] - time.values[0]);
  return {unit_s * time.values[0], static_cast<double>(last) / span_s};
}

/// Begins of turns within the samples.
std::vector<double> turn_begins_s(const Channels& channels, const Instrument& instrument, const Clock& clock,
                                  const std::string& name, std::vector<std::string>& findings) {
  const std::size_t count = channels.rows();
  const double last_s = clock.first_s + static_cast<double>(count - 1) / clock.rate_hz;
  if (!instrument.keyphasor && *instrument.speed_hz > clock.rate_hz / 2)
    throw ConfigError(
        name + ": has fewer than two readings a turn at speed_hz, allowed: up to half the sampling rate");
  if (!instrument.keyphasor) return steady_turns_s(clock.first_s, last_s, instrument.speed_hz.value());
  const Keyphasor& keyphasor = *instrument.keyphasor;
  const Channel& channel = find(channels, keyphasor.column, name);
  std::vector<double> t_s(count);
  for (std::size_t k = 0; k < count; ++k) t_s[k] = clock.first_s + static_cast<double>(k) / clock.rate_hz;
  try {
    const double threshold = keyphasor.threshold ? *keyphasor.threshold : middle_threshold(channel.values);
    const TurnMarks marks =
        numbered_marks(mark_times_s(t_s, channel.values, keyphasor.mark, threshold, keyphasor.hysteresis));
    add_mark_findings(marks, channel.name, findings);
    return smoothed_marks_s(marks.t_s,
                            mark_resolution(channel.values, keyphasor.mark, threshold) / clock.rate_hz);
  } catch (const ConfigError& error) {
    throw ConfigError(fmt::format("{}: '{}': {}", name, channel.name, error.what()));
  }
}

/// Turns that begin and end between two instants.
void keep_between(std::vector<double>& begins_s, std::optional<double> from_s, std::optional<double> to_s) {
  std::erase_if(begins_s, [&](double begin_s) {
    return begin_s < from_s.value_or(begin_s) || begin_s > to_s.value_or(begin_s);
  });
}

/// x + iy of two readings along two directions.
Complex plane_of(double first, double second, double first_rad, double second_rad) {
  const double determinant = std::sin(second_rad - first_rad);
  return {(first * std::sin(second_rad) - second * std::sin(first_rad)) / determinant,
          (second * std::cos(first_rad) - first * std::cos(second_rad)) / determinant};
}

/// Displacement at equal angles of these turns.
std::vector<Complex> turned(const std::vector<std::vector<double>>& readings_m, const Instrument& instrument,
                            const Clock& clock, std::span<const double> turn_begin_s) {
  std::vector<std::vector<double>> probes;
  for (const auto& readings : readings_m)
    probes.push_back(
        at_equal_angles(readings, clock.first_s, clock.rate_hz, turn_begin_s, samples_per_revolution));
  const auto direction = [&](std::size_t i) {
    return instrument.probes[i].angle_deg * std::numbers::pi / 180;
  };
  std::vector<Complex> displacement_m(probes[0].begin(), probes[0].end());
  if (probes.size() == 2) {
    for (std::size_t k = 0; k < displacement_m.size(); ++k)
      displacement_m[k] = plane_of(probes[0][k], probes[1][k], direction(0), direction(1));
  }
  return displacement_m;
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
  Recording recording{.sampling_rate_hz = clock.rate_hz, .plane = instrument.probes.size() == 2};
  const std::vector<double> all_begins_s =
      turn_begins_s(channels, instrument, clock, name, recording.findings);
  recording.turn_begin_s = all_begins_s;
  keep_between(recording.turn_begin_s, instrument.from_s, instrument.to_s);
  if (recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} whole turns of the shaft, allowed: {} or more", name,
                                  std::max(recording.turns(), 0), fewest_turns));
  }
  std::vector<std::vector<double>> readings_m;
  for (const Probe& probe : instrument.probes) {
    const Channel& channel = find(channels, probe.column, name);
    const Scale scale = scale_of(channel.unit, probe, name);
    add_findings(channel, channels, scale.full_scale, recording.findings);
    readings_m.push_back(channel.values);
    for (double& value : readings_m.back()) value *= scale.metres_per_unit;
  }
  recording.displacement_m = turned(readings_m, instrument, clock, recording.turn_begin_s);
  if (instrument.run_out) {
    std::vector<double> slow = all_begins_s;
    keep_between(slow, instrument.run_out->from_s, instrument.run_out->to_s);
    if (slow.size() < 3)
      throw ConfigError(
          fmt::format("{}: holds {} whole turns from run_out.from_s to run_out.to_s, allowed: 2 or more",
                      name, slow.empty() ? 0 : slow.size() - 1));
    subtract_run_out(recording.displacement_m,
                     run_out_of(turned(readings_m, instrument, clock, slow), samples_per_revolution,
                                instrument.run_out->vector));
  }
  if (keep_longest_without_gap(recording) && recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} turns without a gap, allowed: {} or more", name,
                                  recording.turns(), fewest_turns));
  }
  add_speed_findings(recording.turn_begin_s, clock.rate_hz, recording.findings);
  return recording;
}

}  // namespace rubsweep::recording
