#include "rubsweep/measurement/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/findings.hpp"
#include "rubsweep/measurement/recording/found_speed.hpp"
#include "rubsweep/measurement/recording/run_out.hpp"
#include "rubsweep/measurement/recording/speed_column.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;

/// The turns that begin and end between two instants.
std::vector<double> turns_between(std::vector<double> begins_s, std::optional<double> from_s,
                                  std::optional<double> to_s) {
  std::erase_if(begins_s, [&](double begin_s) {
    return begin_s < from_s.value_or(begin_s) || begin_s > to_s.value_or(begin_s);
  });
  return begins_s;
}

/// Displacement x + iy from two readings along two directions.
Complex plane_of(double first, double second, double first_rad, double second_rad) {
  const double determinant = std::sin(second_rad - first_rad);
  return {(first * std::sin(second_rad) - second * std::sin(first_rad)) / determinant,
          (second * std::cos(first_rad) - first * std::cos(second_rad)) / determinant};
}

/// Displacement at equal angles of the given turns.
std::vector<Complex> turned(const std::vector<ProbeSignal>& all, const SampleClock& clock,
                            std::span<const double> turn_begin_s) {
  std::vector<std::vector<double>> probes;
  probes.reserve(all.size());
  for (const ProbeSignal& readings : all)
    probes.push_back(
        at_equal_angles(readings.values, clock.first_s, clock.rate_hz, turn_begin_s, samples_per_revolution));
  const auto direction = [&](std::size_t i) { return all[i].angle_deg * std::numbers::pi / 180; };
  std::vector<Complex> displacement_m(probes[0].begin(), probes[0].end());
  if (probes.size() == 2) {
    for (std::size_t k = 0; k < displacement_m.size(); ++k)
      displacement_m[k] = plane_of(probes[0][k], probes[1][k], direction(0), direction(1));
  }
  return displacement_m;
}

/// Keeps the longest stretch of turns without a gap; returns whether turns were left out.
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

/// Makes displacements of samples of what was measured, over the angular speed, which is taken to be steady
/// unless it changes by more than 2 %. Its rate, which a second integration would need, is left out.
void integrate(double lowest_order, Recording& recording) {
  constexpr double steady = 1.02, fewest_periods = 2;
  Integration& integration = recording.integration;
  integration.lowest_order = std::max(lowest_order, fewest_periods / recording.turns());
  const double mean_rad_per_s = 2 * std::numbers::pi * recording.mean_speed_hz();
  // An offset of the instrument would be no constant over an angular speed that changes.
  Complex offset = 0;
  for (const Complex z : recording.displacement_m)
    offset += z / static_cast<double>(recording.displacement_m.size());
  for (Complex& z : recording.displacement_m) z -= offset;
  recording.measured_m = recording.displacement_m;
  for (Complex& z : recording.measured_m) z *= std::pow(mean_rad_per_s, -integration.times);
  std::vector<double> speeds_hz = turn_speeds_hz(recording.turn_begin_s);
  const auto [slowest, fastest] = std::ranges::minmax(speeds_hz);
  if (fastest <= steady * slowest) std::ranges::fill(speeds_hz, recording.mean_speed_hz());
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double place = static_cast<double>(k) / samples_per_revolution - 0.5;
    const auto turn = std::min(static_cast<std::size_t>(std::max(place, 0.0)), speeds_hz.size() - 2);
    const double speed_hz =
        std::lerp(speeds_hz[turn], speeds_hz[turn + 1], place - static_cast<double>(turn));
    recording.displacement_m[k] *= std::pow(2 * std::numbers::pi * speed_hz, -integration.times);
  }
  recording.displacement_m = integrated(std::move(recording.displacement_m), recording.turns(), integration);
}

/// Puts the speed of the line near the described one in its place.
void find_speed(const Readings& readings, const SampleClock& clock, Instrument& known,
                std::vector<std::string>& findings) {
  if (!known.speed_hz || *known.speed_hz > clock.rate_hz / 2) return;
  const auto looked_at = readings.stretch(clock, known.from_s, known.to_s);
  const double turns = static_cast<double>(looked_at[0].size()) / clock.rate_hz * *known.speed_hz;
  known.speed_hz =
      speed_to_take(*known.speed_hz, speed_near(looked_at, clock.rate_hz, *known.speed_hz), turns, findings);
}

/// All turns of the shaft; those of the evaluated interval become the recording's.
ShaftTurns find_turns(const Channels& channels, Instrument known, const SampleClock& clock,
                      const std::string& name, const Readings& readings, Recording& recording) {
  ShaftTurns all;
  const auto find = [&] {
    all = turns_of(channels, known, clock, name, recording.findings);
    recording.turn_begin_s = turns_between(all.begin_s, known.from_s, known.to_s);
  };
  find();
  if (!known.speed) return all;
  if (const auto factor =
          speed_factor(readings.stretch(clock), clock, recording.turn_begin_s, recording.findings)) {
    known.speed->factor = *factor;
    find();
  }
  return all;
}

/// Subtracts the mean of slow turns.
void correct_run_out(const RunOut& described, const ShaftTurns& all, const Readings& readings,
                     const SampleClock& clock, const std::string& name, Recording& recording) {
  const std::vector<double> slow = turns_between(all.begin_s, described.from_s, described.to_s);
  if (slow.size() < 3)
    throw ConfigError(
        fmt::format("{}: holds {} whole turns from run_out.from_s to run_out.to_s, allowed: 2 or more", name,
                    slow.empty() ? 0 : slow.size() - 1));
  subtract_run_out(recording.displacement_m, run_out_of(turned(readings.probes, clock, slow),
                                                        samples_per_revolution, described.vector));
}

}  // namespace

Recording make_recording(const Channels& all, const Instrument& instrument, const std::string& name,
                         const FollowedTurns* followed) {
  if (instrument.sweep && !followed)
    throw ConfigError(name + ": has a sweep in its description, allowed: a mark or a steady speed");
  std::vector<std::string> jumps;
  const std::optional<Channels> stretch = stretch_without_jump(all, instrument, name, jumps);
  const Channels& channels = stretch ? *stretch : all;
  const SampleClock clock = clock_of(channels, instrument, name);
  Recording recording{.sampling_rate_hz = clock.rate_hz,
                      .plane = instrument.probes.size() == 2,
                      .phased = !followed,
                      .from_rest = instrument.probes.front().rest.has_value(),
                      .machine_group = instrument.machine_group,
                      .zone_limits_mm_per_s = instrument.zone_limits_mm_per_s,
                      .zone_limits_um = instrument.zone_limits_um,
                      .findings = all.notes};
  recording.findings.insert(recording.findings.end(), jumps.begin(), jumps.end());
  Readings readings = readings_of(channels, instrument, name, recording.findings);
  recording.place = readings.place;
  Instrument known = instrument;
  find_speed(readings, clock, known, recording.findings);
  ShaftTurns turns;
  if (followed) {
    recording.findings.push_back(followed->finding);
    turns.begin_s = followed->begin_s;
    recording.turn_begin_s = turns_between(turns.begin_s, instrument.from_s, instrument.to_s);
  } else {
    turns = find_turns(channels, std::move(known), clock, name, readings, recording);
  }
  if (recording.turns() < fewest_turns)
    throw ConfigError(fmt::format("{}: holds {} whole turns of the shaft, allowed: {} or more", name,
                                  std::max(recording.turns(), 0), fewest_turns));
  look_for_faults(readings, clock, recording.turn_begin_s, recording.findings);
  recording.displacement_m = turned(readings.probes, clock, recording.turn_begin_s);
  if (instrument.run_out) correct_run_out(*instrument.run_out, turns, readings, clock, name, recording);
  if (keep_longest_without_gap(recording) && recording.turns() < fewest_turns)
    throw ConfigError(fmt::format("{}: holds {} turns without a gap, allowed: {} or more", name,
                                  recording.turns(), fewest_turns));
  recording.integration.times = readings.integrations();
  if (recording.integration.times > 0) integrate(instrument.lowest_order, recording);
  auto kept = readings.stretch(clock, recording.turn_begin_s.front(), recording.turn_begin_s.back());
  for (std::size_t i = 0; i < kept.size(); ++i) readings.probes[i].values = std::move(kept[i]);
  recording.probes = std::move(readings.probes);
  recording.angle_doubt = instrument.keyphasor
                              ? angle_doubt_of(recording.turn_begin_s, turns)
                              : doubt_without_marks(static_cast<std::size_t>(recording.turns()),
                                                    followed ? 3 * followed->angle_uncertainty_turns : 0);
  add_speed_findings(recording.turn_begin_s, clock.rate_hz, recording.findings);
  return recording;
}

}  // namespace rubsweep::recording
