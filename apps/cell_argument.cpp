#include "cell_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "program.hpp"

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
    const auto speed = number(whole.substr(0, comma)), unbalance = number(whole.substr(comma + 1));
    if (speed && unbalance && *speed > 0 && *unbalance >= 0) return {*speed, *unbalance};
  }
  throw UsageError(fmt::format("--cell {}: allowed: SPEED_HZ,UNBALANCE, a number > 0 and one >= 0", text));
}

}  // namespace rubsweep::apps
