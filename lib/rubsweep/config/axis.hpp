#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/config/section.hpp"
#include "rubsweep/config/value.hpp"

namespace rubsweep::config {

inline constexpr std::string_view axis_forms = "a number, {from, to, count} or {values: [...]}";
inline constexpr long max_axis_values = 10'000;

/// Values of one axis of a sweep: {from, to, count} (count evenly spaced values, both ends included, in
/// either direction; `to` may be left out when count is 1; with `scale: log` at equal ratios) or
/// {values: [...]}, in any order without repetition; a number is a single value. Empty after a problem.
/// What is written is in `range`, and is divided by `units_per_si` before it is spaced.
std::vector<double> read_axis(const Value& value, const model::Range& range, double units_per_si = 1);

/// The same of a section that has keys of its own beside them.
std::vector<double> read_axis_values(Section& section, const model::Range& range, double units_per_si = 1);

}  // namespace rubsweep::config
