#include "rubsweep/measurement/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/table/unit.hpp"
#include "rubsweep/measurement/recording/findings.hpp"
#include "rubsweep/measurement/recording/found_speed.hpp"
#include "rubsweep/measurement/recording/probe_faults.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"
#include "rubsweep/measurement/recording/speed_column.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;

/// Keeps the turns that begin and end between two instants.
void keep_between(std::vector<double>& begins_s, std::optional<double> from_s, std::optional<double> to_s) {
  std::erase_if(begins_s, [&](double begin_s) {
    return begin_s < from_s.value_or(begin_s) || begin_s > to_s.value_or(begin_s);
  });
}

/// Displacement x + iy from two readings along two directions.
Complex plane_of(double first, double second, double first_rad, double second_rad) {
  const double determinant = std::sin(second_rad - first_rad);
  return {(first * std::sin(second_rad) - second * std::sin(first_rad)) / determinant,
          (second * std::cos(first_rad) - first * std::cos(second_rad)) / determinant};
}

/// Readings of all probes in SI units of what they measure.
struct Readings {
  table::Quantity quantity = table::Quantity::length;
  std::vector<ProbeSignal> probes{};
};

int integrations_of(table::Quantity quantity) {
  return quantity == table::Quantity::length ? 0 : quantity == table::Quantity::velocity ? 1 : 2;
}

/// Displacement at equal angles of the given turns.
std::vector<Complex> turned(const std::vector<ProbeSignal>& all, const Instrument& instrument,
                            const SampleClock& clock, std::span<const double> turn_begin_s) {
  std::vector<std::vector<double>> probes;
  probes.reserve(all.size());
  for (const ProbeSignal& readings : all)
    probes.push_back(
        at_equal_angles(readings.values, clock.first_s, clock.rate_hz, turn_begin_s, samples_per_revolution));
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

/// Readings of every probe with outliers replaced. Adds the faults of the readings to the findings.
Readings readings_of(const Channels& channels, const Instrument& instrument, const std::string& name,
                     std::vector<std::string>& findings) {
  Readings all;
  for (const Probe& probe : instrument.probes) {
    Channel channel = find_channel(channels, probe.column, name);
    const Scale scale = scale_of(channel.unit, probe, name);
    const auto refuse = [&](std::string_view wrong, std::string_view allowed) {
      throw ConfigError(fmt::format("{}: '{}': {}, allowed: {}", name, channel.name, wrong, allowed));
    };
    if (all.probes.empty()) all.quantity = scale.quantity;
    if (scale.quantity != all.quantity)
      refuse("measures another quantity than the first probe", "probes of one quantity");
    if (probe.rest && integrations_of(scale.quantity) > 0)
      refuse("measures no displacement and has a reading at rest", "no rest");
    if (instrument.run_out && integrations_of(scale.quantity) > 0)
      refuse("measures no displacement and has a run-out", "no run_out");
    add_wild_findings(replace_wild_readings(channel.values), channel, channels, findings);
    add_findings(channel, channels, scale.full_scale, findings);
    for (double& value : channel.values) value = (value - probe.rest.value_or(0)) * scale.si_per_unit;
    all.probes.push_back({std::move(channel.name), probe.angle_deg, std::move(channel.values)});
  }
  return all;
}

/// Place of the probes. Throws ConfigError where they have two.
Place place_of(const Instrument& instrument, table::Quantity quantity, const std::string& name) {
  const Place usual = quantity == table::Quantity::length ? Place::shaft : Place::casing;
  const Place first = instrument.probes.front().on.value_or(usual);
  if (instrument.probes.back().on.value_or(usual) != first)
    throw ConfigError(name + ": the probes are on different parts (on), allowed: one part");
  return first;
}

/// Index of the first reading at or after an instant.
std::size_t place_of(double t_s, const SampleClock& clock, std::size_t count) {
  const double place = std::ceil((t_s - clock.first_s) * clock.rate_hz - 1e-9);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count)));
}

/// Readings of every probe in the evaluated interval.
std::vector<std::vector<double>> stretch_of(const std::vector<ProbeSignal>& all, const SampleClock& clock,
                                            std::optional<double> from_s, std::optional<double> to_s) {
  std::vector<std::vector<double>> stretch;
  for (const ProbeSignal& readings : all) {
    const auto at = [&](double t_s) {
      return readings.values.begin() +
             static_cast<std::ptrdiff_t>(place_of(t_s, clock, readings.values.size()));
    };
    stretch.emplace_back(from_s ? at(*from_s) : readings.values.begin(),
                         to_s ? at(*to_s) : readings.values.end());
  }
  return stretch;
}

/// Adds the faults that show when probes are compared, and removes the stretch where one of them is stuck, if
/// enough turns are left.
void look_for_faults(std::vector<ProbeSignal>& all, const Recording& recording, const SampleClock& clock,
                     std::vector<std::string>& findings) {
  const std::size_t first = place_of(recording.turn_begin_s.front(), clock, all[0].values.size()),
                    end = place_of(recording.turn_begin_s.back(), clock, all[0].values.size());
  const auto stretch = [&](std::size_t i) { return std::span(all[i].values).subspan(first, end - first); };
  if (all.size() == 2) add_pair_findings({all[0].column, stretch(0)}, {all[1].column, stretch(1)}, findings);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double per_turn = clock.rate_hz / recording.mean_speed_hz();
    const auto still =
        still_stretch(stretch(i), all.size() == 2 ? stretch(1 - i) : std::span<const double>(), per_turn);
    if (!still) continue;
    const double left =
        static_cast<double>(std::max(still->first, end - first - still->first - still->count)) / per_turn;
    const bool enough = left > fewest_turns + 2;
    findings.push_back(fmt::format(
        "'{}' stands still from {:.4g} to {:.4g} s{}", all[i].column,
        clock.first_s + static_cast<double>(first + still->first) / clock.rate_hz,
        clock.first_s + static_cast<double>(first + still->first + still->count - 1) / clock.rate_hz,
        enough ? ": these readings are left out" : ""));
    if (enough) std::ranges::fill(stretch(i).subspan(still->first, still->count), NAN);
  }
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

/// Puts the readings over the evaluated turns into the recording.
void keep_readings(Readings& readings, const SampleClock& clock, Recording& recording) {
  for (ProbeSignal& one : readings.probes) {
    const auto at = [&](double t_s) {
      return one.values.begin() + static_cast<std::ptrdiff_t>(place_of(t_s, clock, one.values.size()));
    };
    one.values = {at(recording.turn_begin_s.front()), at(recording.turn_begin_s.back())};
  }
  recording.probes = std::move(readings.probes);
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
                      .from_rest = instrument.probes.front().rest.has_value()};
  recording.findings = all.notes;
  recording.findings.insert(recording.findings.end(), jumps.begin(), jumps.end());
  Readings readings = readings_of(channels, instrument, name, recording.findings);
  recording.place = place_of(instrument, readings.quantity, name);
  recording.machine_group = instrument.machine_group;
  Instrument known = instrument;
  if (instrument.speed_hz && *instrument.speed_hz <= clock.rate_hz / 2) {
    const auto looked_at = stretch_of(readings.probes, clock, instrument.from_s, instrument.to_s);
    const double turns = static_cast<double>(looked_at[0].size()) / clock.rate_hz * *instrument.speed_hz;
    known.speed_hz =
        speed_to_take(*instrument.speed_hz, speed_near(looked_at, clock.rate_hz, *instrument.speed_hz), turns,
                      recording.findings);
  }
  recording.phased = !followed;
  if (followed) recording.findings.push_back(followed->finding);
  ShaftTurns all_turns = followed ? ShaftTurns{.begin_s = followed->begin_s}
                                  : turns_of(channels, known, clock, name, recording.findings);
  const auto turns_looked_at = [&] {
    recording.turn_begin_s = all_turns.begin_s;
    keep_between(recording.turn_begin_s, instrument.from_s, instrument.to_s);
  };
  turns_looked_at();
  if (known.speed) {
    std::vector<std::vector<double>> probes;
    for (const ProbeSignal& one : readings.probes) probes.push_back(one.values);
    if (const auto factor = speed_factor(probes, clock, recording.turn_begin_s, recording.findings)) {
      known.speed->factor = *factor;
      all_turns = turns_of(channels, known, clock, name, recording.findings);
      turns_looked_at();
    }
  }
  if (recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} whole turns of the shaft, allowed: {} or more", name,
                                  std::max(recording.turns(), 0), fewest_turns));
  }
  look_for_faults(readings.probes, recording, clock, recording.findings);
  recording.displacement_m = turned(readings.probes, instrument, clock, recording.turn_begin_s);
  if (instrument.run_out) {
    std::vector<double> slow = all_turns.begin_s;
    keep_between(slow, instrument.run_out->from_s, instrument.run_out->to_s);
    if (slow.size() < 3)
      throw ConfigError(
          fmt::format("{}: holds {} whole turns from run_out.from_s to run_out.to_s, allowed: 2 or more",
                      name, slow.empty() ? 0 : slow.size() - 1));
    subtract_run_out(recording.displacement_m,
                     run_out_of(turned(readings.probes, instrument, clock, slow), samples_per_revolution,
                                instrument.run_out->vector));
  }
  if (keep_longest_without_gap(recording) && recording.turns() < fewest_turns) {
    throw ConfigError(fmt::format("{}: holds {} turns without a gap, allowed: {} or more", name,
                                  recording.turns(), fewest_turns));
  }
  recording.integration.times = integrations_of(readings.quantity);
  if (recording.integration.times > 0) integrate(instrument.lowest_order, recording);
  keep_readings(readings, clock, recording);
  recording.angle_doubt = instrument.keyphasor
                              ? angle_doubt_of(recording.turn_begin_s, all_turns)
                              : doubt_without_marks(static_cast<std::size_t>(recording.turns()),
                                                    followed ? 3 * followed->angle_uncertainty_turns : 0);
  add_speed_findings(recording.turn_begin_s, clock.rate_hz, recording.findings);
  return recording;
}

std::vector<std::complex<double>> run_out_of(std::span<const std::complex<double>> displacement_m,
                                             int samples_per_turn, bool vector) {
  const auto length = static_cast<std::size_t>(samples_per_turn);
  std::vector<Complex> mean(length);
  double turns = 0;
  for (std::size_t begin = 0; begin + length <= displacement_m.size(); begin += length) {
    const auto turn = displacement_m.subspan(begin, length);
    if (!std::ranges::all_of(turn, [](Complex z) { return std::isfinite(z.real() + z.imag()); })) continue;
    for (std::size_t k = 0; k < length; ++k) mean[k] += turn[k];
    ++turns;
  }
  if (turns == 0) throw ConfigError("run_out: every turn has a gap");
  Complex gap = 0, forward = 0, backward = 0;
  const auto angle = [&](std::size_t k) {
    return 2 * std::numbers::pi * static_cast<double>(k) / samples_per_turn;
  };
  for (std::size_t k = 0; k < length; ++k) {
    mean[k] /= turns;
    gap += mean[k] / static_cast<double>(length);
    forward += mean[k] * std::polar(1.0, -angle(k)) / static_cast<double>(length);
    backward += mean[k] * std::polar(1.0, angle(k)) / static_cast<double>(length);
  }
  for (std::size_t k = 0; k < length; ++k) {
    mean[k] =
        vector ? forward * std::polar(1.0, angle(k)) + backward * std::polar(1.0, -angle(k)) : mean[k] - gap;
  }
  return mean;
}

void subtract_run_out(std::span<std::complex<double>> displacement_m,
                      std::span<const std::complex<double>> run_out_m) {
  for (std::size_t k = 0; k < displacement_m.size(); ++k)
    displacement_m[k] -= run_out_m[k % run_out_m.size()];
}

}  // namespace rubsweep::recording
