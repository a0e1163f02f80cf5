#pragma once

#include <array>
#include <string_view>

#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::config::study {

/// Names of the axes over keys, the fastest first.
inline constexpr std::array<std::string_view, 3> key_axis_names{"x", "y", "z"};

/// `sweep.x`, `sweep.y`, `sweep.z`: {key: PATH} or {keys: [PATH, ...], factors: [...]}, and the values as any
/// other axis has them (see axis.hpp). Whether the keys are there and take the values is for
/// refuse_impossible_axes to see, which needs the whole configuration.
std::vector<sweep::KeyAxis> read_key_axes(yaml::Section& sweep);

/// The keys, factors and values of one axis, from a section that may have keys of its own beside them.
sweep::KeyAxis read_key_axis(yaml::Section& section);

/// The keys beside the values, and how all exclude each other.
std::vector<keys::Key> key_axis_keys();
std::vector<keys::Choice> key_axis_choices();

/// The entries of one axis, into a section that is open.
void print_key_axis(yaml::Printer& printer, const sweep::KeyAxis& axis, AxisPrint how);
void print_key_axes(yaml::Printer& printer, const std::vector<sweep::KeyAxis>& axes, AxisPrint how);

}  // namespace rubsweep::config::study
