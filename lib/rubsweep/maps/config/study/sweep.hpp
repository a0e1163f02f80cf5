#pragma once

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

inline constexpr std::size_t max_cells = 4'000'000;

/// `sweep`: speed and unbalance, each an axis (see axis.hpp) in one of several units (see place_axes.hpp)
/// for a machine that has been read, the axes over keys (see key_axis.hpp), and `refine`: {levels, probes}
/// (see sweep/refinement.hpp).
sweep::Grid read_sweep(const yaml::Value& value, const model::Machine& machine);

keys::Form sweep_form();

/// As it was written, or the values themselves in SI units.
void print_sweep(yaml::Printer& printer, const sweep::Grid& grid, AxisPrint how);

}  // namespace rubsweep::config::study
