#include "rubsweep/measurement/recording/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/findings.hpp"
#include "rubsweep/measurement/recording/probe_faults.hpp"

namespace rubsweep::recording {
namespace {

/// Index of the first reading at or after an instant.
std::size_t index_at(double t_s, const SampleClock& clock, std::size_t count) {
  const double index = std::ceil((t_s - clock.first_s) * clock.rate_hz - 1e-9);
  return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count)));
}

/// Part on which the probes stand. Throws ConfigError where there are two.
Place place_of(const Instrument& instrument, table::Quantity quantity, const std::string& name) {
  const Place usual = quantity == table::Quantity::length ? Place::shaft : Place::casing;
  const Place first = instrument.probes.front().on.value_or(usual);
  if (instrument.probes.back().on.value_or(usual) != first)
    throw ConfigError(name + ": the probes are on different parts (on), allowed: one part");
  return first;
}

}  // namespace

int Readings::integrations() const {
  return quantity == table::Quantity::length ? 0 : quantity == table::Quantity::velocity ? 1 : 2;
}

std::vector<std::vector<double>> Readings::stretch(const SampleClock& clock, std::optional<double> from_s,
                                                   std::optional<double> to_s) const {
  std::vector<std::vector<double>> stretches;
  for (const auto& [column, angle_deg, values] : probes) {
    const std::size_t begin = from_s ? index_at(*from_s, clock, values.size()) : 0,
                      end = to_s ? index_at(*to_s, clock, values.size()) : values.size();
    stretches.emplace_back(values.data() + begin, values.data() + end);
  }
  return stretches;
}

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
    if (probe.rest && all.integrations() > 0)
      refuse("measures no displacement and has a reading at rest", "no rest");
    if (instrument.run_out && all.integrations() > 0)
      refuse("measures no displacement and has a run-out", "no run_out");
    add_wild_findings(replace_wild_readings(channel.values), channel, channels, findings);
    add_findings(channel, channels, scale.full_scale, findings);
    for (double& value : channel.values) value = (value - probe.rest.value_or(0)) * scale.si_per_unit;
    all.probes.push_back({std::move(channel.name), probe.angle_deg, std::move(channel.values)});
  }
  all.place = place_of(instrument, all.quantity, name);
  return all;
}

void look_for_faults(Readings& readings, const SampleClock& clock, std::span<const double> turn_begin_s,
                     std::vector<std::string>& findings) {
  std::vector<ProbeSignal>& all = readings.probes;
  const std::size_t first = index_at(turn_begin_s.front(), clock, all[0].values.size()),
                    end = index_at(turn_begin_s.back(), clock, all[0].values.size());
  const auto stretch = [&](std::size_t i) { return std::span(all[i].values).subspan(first, end - first); };
  if (all.size() == 2) add_pair_findings({all[0].column, stretch(0)}, {all[1].column, stretch(1)}, findings);
  const auto turns = static_cast<double>(turn_begin_s.size() - 1);
  const double per_turn = clock.rate_hz / (turns / (turn_begin_s.back() - turn_begin_s.front()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto still =
        still_stretch(stretch(i), all.size() == 2 ? stretch(1 - i) : std::span<const double>(), per_turn);
    if (!still) continue;
    const double left =
        static_cast<double>(std::max(still->first, end - first - still->first - still->count)) / per_turn;
    const bool enough = left > fewest_turns + 2;
    const auto instant_s = [&](std::size_t k) {
      return clock.first_s + static_cast<double>(first + k) / clock.rate_hz;
    };
    findings.push_back(fmt::format("'{}' stands still from {:.4g} to {:.4g} s{}", all[i].column,
                                   instant_s(still->first), instant_s(still->first + still->count - 1),
                                   enough ? ": these readings are left out" : ""));
    if (enough) std::ranges::fill(stretch(i).subspan(still->first, still->count), NAN);
  }
}

}  // namespace rubsweep::recording
