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

struct Gain {
  std::string_view name;
  table::Quantity quantity = table::Quantity::length;
  double mv_per_unit = 1, unit = 1;  ///< unit in SI
};

std::optional<Gain> gain_of(const Probe& probe) {
  using table::Quantity;
  if (probe.gain_mv_per_um) return Gain{"gain_mv_per_um", Quantity::length, *probe.gain_mv_per_um, 1e-6};
  if (probe.gain_mv_per_mm_per_s)
    return Gain{"gain_mv_per_mm_per_s", Quantity::velocity, *probe.gain_mv_per_mm_per_s, 1e-3};
  if (probe.gain_mv_per_g)
    return Gain{"gain_mv_per_g", Quantity::acceleration, *probe.gain_mv_per_g, table::standard_gravity};
  return std::nullopt;
}

}  // namespace

double seconds_per(const std::string& unit, const std::string& column, const std::string& file) {
  if (unit.empty()) return 1;
  if (const auto size = size_of(table::Quantity::time, unit)) return *size;
  refuse(file, column, fmt::format("the unit '{}' is no time", unit), "s, ms, us");
}

Scale scale_of(const std::string& unit, const Probe& probe, const std::string& file) {
  using table::Quantity;
  constexpr std::string_view gains = "a gain_mv_per_um, gain_mv_per_mm_per_s or gain_mv_per_g";
  const std::string& name = probe.unit ? *probe.unit : unit;
  const auto gain = gain_of(probe);
  for (const Quantity quantity : {Quantity::length, Quantity::velocity, Quantity::acceleration}) {
    const auto size = size_of(quantity, name);
    if (size && gain)
      refuse(file, probe.column, fmt::format("is in {} and has a {}", name, gain->name), "no gain");
    if (size) return {quantity, *size, std::nullopt};
  }
  const bool shares = name == full_scale_unit;
  const auto volts = shares ? probe.range_v.value_or(1) : size_of(Quantity::voltage, name);
  if (!volts) {
    refuse(file, probe.column, name.empty() ? "has no unit" : fmt::format("the unit '{}' is unknown", name),
           fmt::format("m, mm, um, mil, V or mV with {}, FS with a range_v as well; of velocity mm/s, in/s, "
                       "of acceleration g, m/s2",
                       gains));
  }
  if (shares && !probe.range_v)
    refuse(file, probe.column, "is in shares of the full scale and has no range", "a range_v");
  if (!gain) refuse(file, probe.column, fmt::format("is in {} and has no gain", name), gains);
  const double millivolts = 1e3 * *volts;
  Scale scale{gain->quantity, millivolts / gain->mv_per_unit * gain->unit, std::nullopt};
  if (probe.range_v) scale.full_scale = *probe.range_v * 1e3 / millivolts;
  return scale;
}

}  // namespace rubsweep::recording
