#include "shared/cell_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "rubsweep/core/model/speed_text.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& text) {
  throw UsageError(fmt::format(
      "--cell {}: allowed: SPEED_HZ,UNBALANCE or SPEEDrpm,UNBALANCE, a number > 0 and one >= 0", text));
}

bool is_cell(const CellValues& values) { return values.first > 0 && values.second >= 0; }

CellArgument as_cell(const CellValues& values) { return {values.first, values.second}; }

}  // namespace

CellValues read_cell_values(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) refuse(text);
  const std::string_view whole = text;
  std::string_view first_text = whole.substr(0, comma);
  CellValues values;
  values.by_minutes = first_text.ends_with("rpm");
  if (values.by_minutes) first_text.remove_suffix(3);
  const auto first = number(first_text), second = number(whole.substr(comma + 1));
  if (!first || !second) refuse(text);
  values.first = values.by_minutes ? *first / model::rpm_per_hz : *first;
  values.second = *second;
  return values;
}

CellArgument cell_of(const CellValues& values) {
  if (!is_cell(values)) refuse(fmt::format("{},{}", values.first, values.second));
  return as_cell(values);
}

CellArgument read_cell(const std::string& text) {
  const CellValues values = read_cell_values(text);
  if (!is_cell(values)) refuse(text);
  return as_cell(values);
}

}  // namespace rubsweep::apps
