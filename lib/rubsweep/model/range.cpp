#include "rubsweep/model/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rubsweep::model {

bool contains(const Range& range, double value) {
  if (!std::isfinite(value)) return false;
  if (value < range.low || (range.low_open && value == range.low)) return false;
  return !(value > range.high || (range.high_open && value == range.high));
}

std::string describe(const Range& range) {
  std::string text = "a finite number";
  const bool has_low = std::isfinite(range.low);
  if (has_low) text = fmt::format("a number {} {}", range.low_open ? ">" : ">=", range.low);
  if (std::isfinite(range.high)) {
    const char* sign = range.high_open ? "<" : "<=";
    text = has_low ? fmt::format("{} and {} {}", text, sign, range.high)
                   : fmt::format("a number {} {}", sign, range.high);
  }
  return text;
}

}  // namespace rubsweep::model
