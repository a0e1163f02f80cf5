#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config {

inline constexpr long max_axis_values = 10'000;
inline constexpr std::size_t max_cells = 4'000'000;

/// `sweep`: speed_hz and one of whirl_ratio, eccentricity_m. Each is {from, to, count} (count evenly spaced
/// values, both ends included, in either direction; `to` may be left out when count is 1) or {values: [...]},
/// in any order without repetition.
sweep::Grid read_sweep(const Value& value);

/// The values themselves: how they were given is not kept.
void print_sweep(Printer& printer, const sweep::Grid& grid);

}  // namespace rubsweep::config
