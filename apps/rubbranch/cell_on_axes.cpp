#include "cell_on_axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstddef>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// Axes over configuration keys that the command line does not set. `open`: axes with several values; `held`:
/// axes with a single value.
struct KeyAxes {
  std::vector<const sweep::KeyAxis*> open, held;
};

KeyAxes key_axes(const sweep::Grid& grid, const std::vector<std::string>& overrides) {
  KeyAxes axes;
  for (const sweep::KeyAxis& axis : grid.axes) {
    if (config::are_named(axis, overrides)) continue;
    (axis.values.size() == 1 ? axes.held : axes.open).push_back(&axis);
  }
  return axes;
}

void write_keys(const sweep::KeyAxis& axis, double value, std::vector<std::string>& overrides) {
  for (const sweep::KeyValue& at : sweep::keys_at(axis, value))
    overrides.push_back(at.key + "=" + batch::csv_number(at.value));
}

/// Throws unless exactly two axes have several values.
void require_two(const sweep::Grid& grid, const KeyAxes& axes) {
  std::vector<std::string> names;
  if (grid.speed_hz.size() > 1) names.emplace_back("speed_hz");
  if (grid.unbalance.size() > 1) names.emplace_back(to_string(grid.measure));
  for (const sweep::KeyAxis* axis : axes.open) names.push_back(axis->keys.front());
  if (names.size() == 2) return;
  throw ConfigError(
      fmt::format("--cell: X,Y say the place on two axes of the sweep, and {} of its axes have several "
                  "values ({}), allowed: "
                  "--set {}=VALUE for a sweep of two, or for the speed and the unbalance of --cell",
                  names.size(), fmt::join(names, ", "), axes.open.front()->keys.front()));
}

}  // namespace

CellOnAxes cell_on_axes(const CellValues& values, const sweep::Grid& grid,
                        const std::vector<std::string>& overrides) {
  const KeyAxes axes = key_axes(grid, overrides);
  CellOnAxes result;
  for (const sweep::KeyAxis* axis : axes.held) write_keys(*axis, axis->values.front(), result.overrides);
  if (axes.open.empty()) {
    result.cell = cell_of(values);
    return result;
  }
  require_two(grid, axes);
  if (values.by_minutes && grid.speed_hz.size() == 1)
    throw UsageError("--cell: rpm belong to a speed, and the sweep has only one");
  const std::array all{values.first, values.second};
  std::size_t next = 0;
  CellValues place{grid.speed_hz.front(), grid.unbalance.front()};
  if (grid.speed_hz.size() > 1) place.first = all.at(next++);
  if (grid.unbalance.size() > 1) place.second = all.at(next++);
  for (const sweep::KeyAxis* axis : axes.open) write_keys(*axis, all.at(next++), result.overrides);
  result.cell = cell_of(place);
  return result;
}

}  // namespace rubsweep::apps
