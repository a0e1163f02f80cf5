#include "rubsweep/measurement/recording/channels.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/table/unit.hpp"

namespace rubsweep::recording {
namespace {

/// Size of a unit of this quantity; empty for units of other quantities.
std::optional<double> size_of(table::Quantity quantity, std::string_view name) {
  const auto unit = table::unit_of(name);
  return unit && unit->quantity == quantity ? std::optional(unit->in_si) : std::nullopt;
}

[[noreturn]] void refuse(const std::string& file, const std::string& column, const std::string& wrong,
                         std::string_view allowed) {
  throw ConfigError(fmt::format("{}: '{}': {}, allowed: {}", file, column, wrong, allowed));
}

}  // namespace

double seconds_per(const std::string& unit, const std::string& column, const std::string& file) {
  if (unit.empty()) return 1;
  if (const auto size = size_of(table::Quantity::time, unit)) return *size;
  refuse(file, column, fmt::format("the unit '{}' is no time", unit), "s, ms, us");
}

Scale scale_of(const std::string& unit, const Probe& probe, const std::string& file) {
  const std::string& name = probe.unit ? *probe.unit : unit;
  if (const auto size = size_of(table::Quantity::length, name)) {
    if (probe.gain_mv_per_um)
      refuse(file, probe.column, fmt::format("is in {} and has a gain_mv_per_um", name), "no gain");
    return {*size, std::nullopt};
  }
  const bool shares = name == full_scale_unit;
  const auto volts = shares ? probe.range_v.value_or(1) : size_of(table::Quantity::voltage, name);
  if (!volts) {
    refuse(file, probe.column, name.empty() ? "has no unit" : fmt::format("the unit '{}' is unknown", name),
           "m, mm, um, mil, V or mV with a gain_mv_per_um, and FS with a range_v as well");
  }
  if (shares && !probe.range_v)
    refuse(file, probe.column, "is in shares of the full scale and has no range", "a range_v");
  if (!probe.gain_mv_per_um)
    refuse(file, probe.column, fmt::format("is in {} and has no gain", name), "a gain_mv_per_um");
  const double millivolts = 1e3 * *volts;
  Scale scale{millivolts / *probe.gain_mv_per_um * 1e-6, std::nullopt};
  if (probe.range_v) scale.full_scale = *probe.range_v * 1e3 / millivolts;
  return scale;
}

}  // namespace rubsweep::recording
