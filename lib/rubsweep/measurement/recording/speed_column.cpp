#include "rubsweep/measurement/recording/speed_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/table/unit.hpp"
#include "rubsweep/measurement/recording/found_speed.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::recording {
namespace {

/// Speeds in turns per second, with gaps bridged by a straight line.
std::vector<double> speeds_of(const Channel& channel, const SpeedColumn& speed, const std::string& name) {
  const std::string unit = speed.unit.value_or(channel.unit);
  const auto known = table::unit_of(unit);
  if (!known || known->quantity != table::Quantity::turning)
    throw ConfigError(
        fmt::format("{}: '{}': {}, allowed: Hz, rpm, rad/s", name, channel.name,
                    unit.empty() ? "has no unit" : fmt::format("the unit '{}' is none of a speed", unit)));
  std::vector<double> speeds = channel.values;
  std::size_t last = speeds.size();
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (!std::isfinite(speeds[k])) continue;
    if (speeds[k] < 0)
      throw ConfigError(
          fmt::format("{}: '{}' is {:g}, allowed: speeds of 0 and more", name, channel.name, speeds[k]));
    const std::size_t from = last == speeds.size() ? 0 : last + 1;
    for (std::size_t i = from; i < k; ++i) {
      const double share = static_cast<double>(i - from + 1) / static_cast<double>(k - from + 1);
      speeds[i] = from == 0 ? speeds[k] : speeds[last] + share * (speeds[k] - speeds[last]);
    }
    last = k;
  }
  if (last == speeds.size())
    throw ConfigError(fmt::format("{}: '{}' has no number, allowed: speeds", name, channel.name));
  std::fill(speeds.begin() + static_cast<std::ptrdiff_t>(last), speeds.end(), speeds[last]);
  for (double& one : speeds) one *= known->in_si * speed.factor;
  return speeds;
}

}  // namespace

std::vector<double> turns_by_speed(const Channels& channels, const SpeedColumn& speed,
                                   const SampleClock& clock, const std::string& name) {
  const Channel& channel = find_channel(channels, speed.column, name);
  const std::vector<double> speeds = speeds_of(channel, speed, name);
  if (const double fastest = *std::ranges::max_element(speeds); fastest > clock.rate_hz / 2)
    throw ConfigError(
        fmt::format("{}: '{}' has fewer than two readings a turn at {:g} Hz, allowed: up to half the "
                    "sampling rate",
                    name, channel.name, fastest));
  const double step_s = 1 / clock.rate_hz;
  std::vector<double> begins_s{clock.first_s};
  double turned = 0;
  for (std::size_t k = 0; k + 1 < speeds.size(); ++k) {
    const double now = speeds[k], rate = (speeds[k + 1] - now) / step_s;
    const double end = turned + (now + speeds[k + 1]) / 2 * step_s;
    for (auto next = static_cast<double>(begins_s.size()); next <= end;
         next = static_cast<double>(begins_s.size())) {
      const double left = next - turned;
      const double after_s = 2 * left / (now + std::sqrt(std::max(0.0, now * now + 2 * rate * left)));
      begins_s.push_back(clock.first_s + (static_cast<double>(k) * step_s) + std::min(after_s, step_s));
    }
    turned = end;
  }
  return begins_s;
}

std::optional<double> speed_factor(const std::vector<std::vector<double>>& probes, const SampleClock& clock,
                                   std::span<const double> turn_begin_s, std::vector<std::string>& findings) {
  constexpr double steady = 0.02, small_turns = 1e-3, sure = 3;
  constexpr int readings_per_turn = 32;
  if (turn_begin_s.size() < 2) return std::nullopt;
  const std::vector<double> speeds = turn_speeds_hz(turn_begin_s);
  const auto [slowest, fastest] = std::ranges::minmax_element(speeds);
  if (*fastest > (1 + steady) * *slowest) return std::nullopt;
  std::vector<std::vector<double>> turned;
  for (const std::vector<double>& readings : probes)
    turned.push_back(
        at_equal_angles(readings, clock.first_s, clock.rate_hz, turn_begin_s, readings_per_turn));
  // Here the unit of time is a turn, so the shaft's line lies near 1.
  const auto found = speed_near(turned, readings_per_turn, 1);
  if (!found || found->speed_hz == 0) return std::nullopt;
  const double off = std::abs(found->speed_hz - 1);
  if (off * static_cast<double>(speeds.size()) < small_turns || off < sure * found->uncertainty_hz)
    return std::nullopt;
  findings.push_back(
      fmt::format("the speed is taken from the signal: {:.5g} +- {:.2g} times that of its column",
                  found->speed_hz, found->uncertainty_hz));
  return found->speed_hz;
}

}  // namespace rubsweep::recording
