#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/sweep/refinement.hpp"

namespace rubsweep::sweep {

/// A number under a key of the configuration, as `--set KEY=VALUE` would write it.
struct KeyValue {
  std::string key;  ///< dotted path, such as stops.0.friction.coefficient
  double value = 0;
};

/// An axis of a sweep over numbers of the configuration, in the units of their keys. At its i-th place each
/// key holds values[i] times its own factor.
struct KeyAxis {
  std::vector<std::string> keys;            ///< keys, at least one
  std::vector<double> factors;              ///< factor of each key
  std::vector<double> values;               ///< values, at least one, all different
  std::optional<batch::Spacing> spacing{};  ///< how they are written; empty where they are listed
};

/// Values of all keys of an axis at one of its values.
std::vector<KeyValue> keys_at(const KeyAxis& axis, double value);

/// Form in which a person wrote speeds or unbalances, for output. No number of a map depends on it.
struct WrittenAxis {
  std::string key{};                        ///< such as speed_rpm; empty: in SI units
  std::string unit{};                       ///< such as "rpm" or "g mm"
  double units_per_si = 1;                  ///< how many of that unit are one in SI
  std::optional<batch::Spacing> spacing{};  ///< spacing in that unit; empty where values were listed
  double rated_speed_hz = 0;                ///< rated speed of a balance grade

  bool is_si() const { return key.empty(); }
};

/// A number in SI units as text in the unit that it was written in. The 15 digits that are kept hide that it
/// was divided and multiplied: 3100 rpm do not come back as 3100.0000000000005.
std::string in_units(const WrittenAxis& axis, double si);

/// The text of in_units where it reads back as the same number in SI units, else empty.
std::optional<std::string> exactly_in_units(const WrittenAxis& axis, double si);

/// Quantity on the second axis of the map.
enum class UnbalanceMeasure {
  whirl_ratio,    ///< largest normal excursion of the quiet motion / remaining clearance at the first stop
  eccentricity_m  ///< e of the disc, in metres
};

/// Its key in a configuration and its column of map.csv.
constexpr std::string_view to_string(UnbalanceMeasure measure) { return enumerator_word(measure); }

/// Grid of cells. Speeds in Hz, strictly > 0; unbalance values >= 0 in the unit of `measure`.
struct Grid {
  std::vector<double> speed_hz;
  UnbalanceMeasure measure = UnbalanceMeasure::whirl_ratio;
  std::vector<double> unbalance;
  std::vector<KeyAxis> axes{};             ///< x, y, z: each slower than those before it
  std::optional<Refinement> refinement{};  ///< empty: every cell is computed
  WrittenAxis written_speed{}, written_unbalance{};
};

/// Cells of the grid, speed fastest, then unbalance, then the axes over keys:
/// cell = (... i_x) * unbalances * speeds + i_unbalance * speeds + i_speed.
std::size_t cell_count(const Grid& grid);

/// A value of the second axis as the scene takes it.
scene::Unbalance unbalance_of(const Grid& grid, double value);

/// Where a cell < cell_count(grid) lies.
scene::Place place_of(const Grid& grid, std::size_t cell);

/// Every key of every axis, in their order: the columns that a map has for them.
std::vector<std::string> key_names(const Grid& grid);

/// Values of these keys in a cell < cell_count(grid), in the same order.
std::vector<KeyValue> key_values(const Grid& grid, std::size_t cell);

/// The columns that say where a cell < cell_count(grid) lies, with its numbers: speed_hz, the measure of the
/// unbalance, then all keys.
std::vector<KeyValue> columns_of_place(const Grid& grid, std::size_t cell);

/// An axis with more than one value.
struct SweptAxis {
  std::string name;  ///< speed_hz, the measure of the unbalance, or the first key of the axis
  std::vector<double> values;
};

/// The axes with more than one value, fastest first.
std::vector<SweptAxis> swept_axes(const Grid& grid);

/// The first axis whose values neither rise nor fall all along: next to each other in the grid are then not
/// cells that are neighbours on the axis. Empty where there is none.
std::optional<std::string> disordered_axis(const Grid& grid);

/// The grid of the one cell there.
Grid grid_of(const scene::Place& place);

}  // namespace rubsweep::sweep
