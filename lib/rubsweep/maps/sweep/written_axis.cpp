#include "rubsweep/maps/sweep/written_axis.hpp"

#include <fmt/format.h>

#include <charconv>

namespace rubsweep::sweep {
namespace {

double read_back(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::string in_units(const WrittenAxis& axis, double si) {
  if (axis.units_per_si == 1) return fmt::format("{}", si);
  return fmt::format("{}", read_back(fmt::format("{:.15g}", si * axis.units_per_si)));
}

std::optional<std::string> exactly_in_units(const WrittenAxis& axis, double si) {
  std::string text = in_units(axis, si);
  if (read_back(text) / axis.units_per_si != si) return std::nullopt;
  return text;
}

}  // namespace rubsweep::sweep
