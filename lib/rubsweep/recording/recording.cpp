#include "rubsweep/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/findings.hpp"
#include "rubsweep/recording/run_out.hpp"
#include "rubsweep/recording/sample_clock.hpp"
#include "rubsweep/recording/turns.hpp"
#include "rubsweep/recording/unit.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;

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
                            const SampleClock& clock, std::span<const double> turn_begin_s) {
  std::vector<std::vector<double>> probes;
  probes.reserve(readings_m.size());
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

Recording make_recording(const Channels& all, const Instrument& instrument, const std::string& name) {
  std::vector<std::string> jumps;
  const std::optional<Channels> stretch = stretch_without_jump(all, instrument, name, jumps);
  const Channels& channels = stretch ? *stretch : all;
  const SampleClock clock = clock_of(channels, instrument, name);
  Recording recording{.sampling_rate_hz = clock.rate_hz,
                      .plane = instrument.probes.size() == 2,
                      .from_rest = instrument.probes.front().rest.has_value()};
  const ShaftTurns all_turns = turns_of(channels, instrument, clock, name, recording.findings);
  recording.findings.insert(recording.findings.begin(), jumps.begin(), jumps.end());
  recording.turn_begin_s = all_turns.begin_s;
  keep_between(recording.turn_begin_s, instrument.from_s, instrument.to_s);
  if (recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} whole turns of the shaft, allowed: {} or more", name,
                                  std::max(recording.turns(), 0), fewest_turns));
  }
  std::vector<std::vector<double>> readings_m;
  for (const Probe& probe : instrument.probes) {
    const Channel& channel = find_channel(channels, probe.column, name);
    const Scale scale = scale_of(channel.unit, probe, name);
    add_findings(channel, channels, scale.full_scale, recording.findings);
    readings_m.push_back(channel.values);
    for (double& value : readings_m.back()) value = (value - probe.rest.value_or(0)) * scale.metres_per_unit;
  }
  recording.displacement_m = turned(readings_m, instrument, clock, recording.turn_begin_s);
  if (instrument.run_out) {
    std::vector<double> slow = all_turns.begin_s;
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
  recording.angle_doubt = angle_doubt_of(recording.turn_begin_s, all_turns);
  add_speed_findings(recording.turn_begin_s, clock.rate_hz, recording.findings);
  return recording;
}

}  // namespace rubsweep::recording
