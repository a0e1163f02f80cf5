#include "cell_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "program.hpp"
#include "rubsweep/config/place_axes.hpp"

namespace rubsweep::apps {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

CellArgument read_cell(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos) {
    const std::string_view whole = text;
    std::string_view speed_text = whole.substr(0, comma);
    const bool by_minutes = speed_text.ends_with("rpm");
    if (by_minutes) speed_text.remove_suffix(3);
    const auto speed = number(speed_text), unbalance = number(whole.substr(comma + 1));
    if (speed && unbalance && *speed > 0 && *unbalance >= 0)
      return {by_minutes ? *speed / config::rpm_per_hz : *speed, *unbalance};
  }
  throw UsageError(fmt::format(
      "--cell {}: allowed: SPEED_HZ,UNBALANCE or SPEEDrpm,UNBALANCE, a number > 0 and one >= 0", text));
}

}  // namespace rubsweep::apps
