#pragma once

#include "rubsweep/config/axis.hpp"
#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config {

inline constexpr std::size_t max_cells = 4'000'000;

/// `sweep`: speed_hz and one of whirl_ratio, eccentricity_m, each an axis (see axis.hpp), and the axes over
/// keys (see key_axis.hpp), and `refine`: {levels, probes} (see sweep/refinement.hpp).
sweep::Grid read_sweep(const Value& value);

/// The values themselves: how they were given is not kept.
void print_sweep(Printer& printer, const sweep::Grid& grid);

}  // namespace rubsweep::config
