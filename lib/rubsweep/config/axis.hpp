#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/config/section.hpp"
#include "rubsweep/config/value.hpp"

namespace rubsweep::config {

inline constexpr std::string_view axis_forms = "{from, to, count} or {values: [...]}";
inline constexpr long max_axis_values = 10'000;

/// Values of one axis of a sweep: {from, to, count} (count evenly spaced values, both ends included, in
/// either direction; `to` may be left out when count is 1; with `scale: log` at equal ratios) or
/// {values: [...]}, in any order without repetition. Empty after a problem.
std::vector<double> read_axis(const Value& value, const model::Range& range);

/// The same of a section that has keys of its own beside them.
std::vector<double> read_axis_values(Section& section, const model::Range& range);

}  // namespace rubsweep::config
