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

/// Purpose of printed axes: `as_written` for people, by ends and count where they were given so and in the
/// unit of the person; `by_value` for a digest, which must not depend on how a file is written.
enum class AxisPrint { as_written, by_value };

/// Values of one axis in SI units, and how they are written where that is no list.
struct AxisValues {
  std::vector<double> values;
  std::optional<batch::Spacing> spacing;
};

/// Values of one axis of a sweep: {from, to, count} (count evenly spaced values, both ends included, in
/// either direction; `to` may be left out when count is 1; with `scale: log` at equal ratios), {from, to,
/// step} (each value the double nearest to its decimal) or {values: [...]}, in any order without repetition;
/// a number is a single value. Empty after a problem. Written values are in `range`, and are divided by
/// `units_per_si` before it is spaced.
AxisValues read_axis(const yaml::Value& value, const model::Range& range, double units_per_si = 1);

/// The same as keys: of a map, how they exclude each other, and of an axis that may be a number.
std::vector<keys::Key> spaced_keys(const model::Range& range);
keys::Form axis_form(const model::Range& range);

/// The entries of an axis as they were written, into a map that is open: from, to, count and scale, or step,
/// where `spacing` says how `values` are made, else the values.
void print_axis_values(yaml::Printer& printer, const std::vector<double>& values,
                       const std::optional<batch::Spacing>& spacing, double units_per_si = 1);

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
