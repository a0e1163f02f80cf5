#include "rubsweep/measurement/recording/channels.hpp"

#include <fmt/format.h>

#include <array>
#include <span>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

/// The last two units are the micro sign and the Greek letter mu, which look alike.
constexpr std::array<Unit, 7> times{
    {{"", 1}, {"s", 1}, {"sec", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"\u00b5s", 1e-6}, {"\u03bcs", 1e-6}}};
constexpr std::array<Unit, 6> lengths{
    {{"m", 1}, {"mm", 1e-3}, {"um", 1e-6}, {"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}, {"mil", 25.4e-6}}};
constexpr std::array<Unit, 4> voltages{{{"V", 1e3}, {"Volt", 1e3}, {"Volts", 1e3}, {"mV", 1}}};

std::optional<double> size_of(std::span<const Unit> units, std::string_view name) {
  for (const Unit& unit : units)
    if (unit.name == name) return unit.size;
  return std::nullopt;
}

[[noreturn]] void refuse(const std::string& file, const std::string& column, const std::string& wrong,
                         std::string_view allowed) {
  throw ConfigError(fmt::format("{}: '{}': {}, allowed: {}", file, column, wrong, allowed));
}

}  // namespace

double seconds_per(const std::string& unit, const std::string& column, const std::string& file) {
  if (const auto size = size_of(times, unit)) return *size;
  refuse(file, column, fmt::format("the unit '{}' is no time", unit), "s, ms, us");
}

Scale scale_of(const std::string& unit, const Probe& probe, const std::string& file) {
  const std::string& name = probe.unit ? *probe.unit : unit;
  if (const auto size = size_of(lengths, name)) {
    if (probe.gain_mv_per_um)
      refuse(file, probe.column, fmt::format("is in {} and has a gain_mv_per_um", name), "no gain");
    return {*size, std::nullopt};
  }
  const bool shares = name == full_scale_unit;
  const auto millivolts = shares ? probe.range_v.value_or(1) * 1e3 : size_of(voltages, name);
  if (!millivolts) {
    refuse(file, probe.column, name.empty() ? "has no unit" : fmt::format("the unit '{}' is unknown", name),
           "m, mm, um, mil, V or mV with a gain_mv_per_um, and FS with a range_v as well");
  }
  if (shares && !probe.range_v)
    refuse(file, probe.column, "is in shares of the full scale and has no range", "a range_v");
  if (!probe.gain_mv_per_um)
    refuse(file, probe.column, fmt::format("is in {} and has no gain", name), "a gain_mv_per_um");
  Scale scale{*millivolts / *probe.gain_mv_per_um * 1e-6, std::nullopt};
  if (probe.range_v) scale.full_scale = *probe.range_v * 1e3 / *millivolts;
  return scale;
}

}  // namespace rubsweep::recording
