#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/sweep/refinement.hpp"

namespace rubsweep::sweep {

/// Number for a key of the configuration, as `--set KEY=VALUE` would write it.
struct KeyValue {
  std::string key;  ///< dotted path, such as stops.0.friction.coefficient
  double value = 0;
};

/// Axis of a sweep over numbers of the configuration, in the units of their keys. At its i-th value each key
/// has the number values[i] times the factor of the key.
struct KeyAxis {
  std::vector<std::string> keys;            ///< keys, at least one
  std::vector<double> factors;              ///< factor of each key
  std::vector<double> values;               ///< values, at least one, all different
  std::optional<batch::Spacing> spacing{};  ///< spacing of a range of values; empty for a list of values
};

/// Numbers of all keys of an axis at one value of the axis.
std::vector<KeyValue> keys_at(const KeyAxis& axis, double value);

/// Key and unit in which a person wrote speeds or unbalances, for output. No number of a map depends on them.
struct WrittenAxis {
  std::string key{};        ///< such as speed_rpm; empty: in SI units
  std::string unit{};       ///< such as "rpm" or "g mm"
  double units_per_si = 1;  ///< 1 SI unit in that unit, such as 60 for rpm
  /// spacing of the values in the written unit; empty where values were listed
  std::optional<batch::Spacing> spacing{};
  double rated_speed_hz = 0;  ///< rated speed of a balance grade

  bool is_si() const { return key.empty(); }
};

/// A number given in SI units, as text in the unit of the axis. It has 15 digits, so that rounding by the
/// conversion does not show: 3100 rpm do not come back as 3100.0000000000005.
std::string in_units(const WrittenAxis& axis, double si);

/// Text of in_units if it reads back as the same number in SI units, else empty.
std::optional<std::string> exactly_in_units(const WrittenAxis& axis, double si);

/// Quantity on the second axis of the map.
enum class UnbalanceMeasure {
  whirl_ratio,    ///< largest normal excursion of the quiet motion / remaining clearance at the first stop
  eccentricity_m  ///< e of the disc, in metres
};

/// Key of the measure in a configuration, and name of its column in map.csv.
constexpr std::string_view to_string(UnbalanceMeasure measure) { return enumerator_word(measure); }

/// Grid of cells. Speeds in Hz, strictly > 0; unbalance values >= 0 in the unit of `measure`.
struct Grid {
  std::vector<double> speed_hz;
  UnbalanceMeasure measure = UnbalanceMeasure::whirl_ratio;
  std::vector<double> unbalance;
  std::vector<KeyAxis> axes{};             ///< x, y, z: each varies more slowly than those before it
  std::optional<Refinement> refinement{};  ///< empty: every cell is computed
  WrittenAxis written_speed{}, written_unbalance{};
};

/// Cells of the grid, speed fastest, then unbalance, then the axes over keys:
/// cell = (... i_x) * unbalances * speeds + i_unbalance * speeds + i_speed.
std::size_t cell_count(const Grid& grid);

/// Unbalance of a scene from a value of the second axis.
scene::Unbalance unbalance_of(const Grid& grid, double value);

/// Place of a cell < cell_count(grid) in the grid: its speed and unbalance.
scene::Place place_of(const Grid& grid, std::size_t cell);

/// Keys of all axes over keys, in the order of their columns in a map.
std::vector<std::string> key_names(const Grid& grid);

/// Numbers of these keys in a cell < cell_count(grid), in the same order.
std::vector<KeyValue> key_values(const Grid& grid, std::size_t cell);

/// Columns for the position of a cell < cell_count(grid), with their numbers: speed_hz, the measure of the
/// unbalance, then all keys.
std::vector<KeyValue> columns_of_place(const Grid& grid, std::size_t cell);

/// An axis with more than one value.
struct SweptAxis {
  std::string name;  ///< speed_hz, the measure of the unbalance, or the first key of the axis
  std::vector<double> values;
};

std::vector<SweptAxis> swept_axes(const Grid& grid);  ///< All axes of several values, the fastest first.

/// First axis whose values neither rise nor fall throughout, so that neighbours in the grid are no neighbours
/// on the axis. Empty where there is no such axis.
std::optional<std::string> disordered_axis(const Grid& grid);

Grid grid_of(const scene::Place& place);  ///< Grid with the single cell at `place`.

}  // namespace rubsweep::sweep
