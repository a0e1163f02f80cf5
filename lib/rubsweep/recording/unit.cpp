#include "rubsweep/recording/unit.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string_view>

#include "rubsweep/error.hpp"

namespace rubsweep::recording {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

/// The micro sign and the Greek letter look alike.
constexpr std::array<Unit, 6> times{
    {{"", 1}, {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"\u00b5s", 1e-6}, {"\u03bcs", 1e-6}}};
constexpr std::array<Unit, 6> lengths{
    {{"m", 1}, {"mm", 1e-3}, {"um", 1e-6}, {"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}, {"mil", 25.4e-6}}};
constexpr std::array<Unit, 2> voltages{{{"V", 1e3}, {"mV", 1}}};

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

double metres_per(const std::string& unit, const std::string& column, std::optional<double> gain_mv_per_um,
                  const std::string& file) {
  if (const auto size = size_of(lengths, unit)) {
    if (gain_mv_per_um)
      refuse(file, column, fmt::format("is in {} and has a gain_mv_per_um", unit), "no gain");
    return *size;
  }
  if (const auto millivolts = size_of(voltages, unit)) {
    if (!gain_mv_per_um)
      refuse(file, column, fmt::format("is in {} and has no gain", unit), "a gain_mv_per_um");
    return *millivolts / *gain_mv_per_um * 1e-6;
  }
  refuse(file, column, unit.empty() ? "has no unit" : fmt::format("the unit '{}' is unknown", unit),
         "m, mm, um, mil, and V or mV with a gain_mv_per_um");
}

}  // namespace rubsweep::recording
