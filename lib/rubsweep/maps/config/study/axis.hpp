#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::config::study {

/// Spacing of numbers from one end to the other.
enum class Scale { linear, log };
inline constexpr auto scales = words_of<Scale>();

inline constexpr std::string_view axis_forms =
    "a number, {from, to, count}, {from, to, step} or {values: [...]}";
inline constexpr long max_axis_values = 10'000;

/// Purpose of printed axes. `as_written` is for people: with ends and count if these were given, in the unit
/// of the file. `by_value` is for a digest, which must not depend on how a file is written.
enum class AxisPrint { as_written, by_value };

/// Values of one axis in SI units, and their spacing if they were not given as a list.
struct AxisValues {
  std::vector<double> values;
  std::optional<batch::Spacing> spacing;
};

/// Reads one axis of a sweep, in any of four forms. {from, to, count}: count evenly spaced values, both ends
/// included, in either direction; `to` may be left out for count 1; with `scale: log` neighbours have equal
/// ratios. {from, to, step}: each value is the double nearest to its decimal. {values: [...]}: any order
/// without repetition. A number: a single value. Empty after a problem. Written values must be in `range`;
/// they are divided by `units_per_si` before the axis is spaced.
AxisValues read_axis(const yaml::Value& value, const model::Range& range, double units_per_si = 1);

/// Keys of an axis as a map, and form of an axis, which may also be a number.
std::vector<keys::Key> spaced_keys(const model::Range& range);
keys::Form axis_form(const model::Range& range);

/// Prints an axis as it was written into an open map: from, to, count and scale, or step, where `spacing`
/// describes `values`; otherwise the values.
void print_axis_values(yaml::Printer& printer, const std::vector<double>& values,
                       const std::optional<batch::Spacing>& spacing, double units_per_si = 1);

/// Names of the axes over keys. The first varies fastest.
inline constexpr std::array<std::string_view, 3> key_axis_names{"x", "y", "z"};

/// Reads `sweep.x`, `sweep.y`, `sweep.z`: {key: PATH} or {keys: [PATH, ...], factors: [...]}, with values as
/// in any other axis. Whether the keys exist and accept the values is checked later by vary_keys, because
/// this check needs the whole configuration.
std::vector<sweep::KeyAxis> read_key_axes(yaml::Section& sweep);

/// Reads keys, factors and values of one axis from a section that may also have other keys.
sweep::KeyAxis read_key_axis(yaml::Section& section);

/// Keys of an axis over keys, except those for its values, and how they exclude each other.
std::vector<keys::Key> key_axis_keys();
std::vector<keys::Choice> key_axis_choices();

/// Prints one axis over keys into an open section.
void print_key_axis(yaml::Printer& printer, const sweep::KeyAxis& axis, AxisPrint how);
void print_key_axes(yaml::Printer& printer, const std::vector<sweep::KeyAxis>& axes, AxisPrint how);

}  // namespace rubsweep::config::study
