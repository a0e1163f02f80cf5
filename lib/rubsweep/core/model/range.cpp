#include "rubsweep/core/model/range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace rubsweep::model {
namespace {

bool inside(const Range& range, double value) {
  if (value < range.low || (range.low_open && value == range.low)) return false;
  return !(value > range.high || (range.high_open && value == range.high));
}

bool of_any_machine(double value) {
  const double magnitude = std::abs(value);
  return magnitude == 0 || (magnitude >= smallest_magnitude && magnitude <= largest_magnitude);
}

/// A number with nine digits if only rounding, or the rounding margin of a bound, is lost.
std::string short_text(double value) {
  constexpr double rounding = 2e-10;
  const std::string rounded = fmt::format("{:.9g}", value);
  const bool same = std::abs(std::strtod(rounded.c_str(), nullptr) - value) <= rounding * std::abs(value);
  return same ? fmt::format("{}", std::strtod(rounded.c_str(), nullptr)) : fmt::format("{}", value);
}

}  // namespace

bool contains(const Range& range, double value) {
  return std::isfinite(value) && of_any_machine(value) && inside(range, value);
}

std::string describe(const Range& range, double value) {
  if (!std::isfinite(value) || !inside(range, value)) return describe(range);
  return fmt::format("{}{} to {} in magnitude", inside(range, 0) ? "0, or " : "", smallest_magnitude,
                     largest_magnitude);
}

std::string describe(const Range& range) {
  std::string text = "a finite number";
  const bool has_low = std::isfinite(range.low);
  if (has_low) text = fmt::format("a number {} {}", range.low_open ? ">" : ">=", range.low);
  if (std::isfinite(range.high)) {
    const char* sign = range.high_open ? "<" : "<=";
    const std::string high = short_text(range.high);
    text =
        has_low ? fmt::format("{} and {} {}", text, sign, high) : fmt::format("a number {} {}", sign, high);
  }
  return text;
}

}  // namespace rubsweep::model
