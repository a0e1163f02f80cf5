#include "rubsweep/maps/sweep/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <utility>
#include <variant>

#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::sweep {
namespace {

double read_back(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::vector<KeyValue> keys_at(const KeyAxis& axis, double value) {
  std::vector<KeyValue> keys;
  for (std::size_t i = 0; i < axis.keys.size(); ++i) keys.push_back({axis.keys[i], axis.factors[i] * value});
  return keys;
}

std::string in_units(const WrittenAxis& axis, double si) {
  if (axis.units_per_si == 1) return fmt::format("{}", si);
  return fmt::format("{}", read_back(fmt::format("{:.15g}", si * axis.units_per_si)));
}

std::optional<std::string> exactly_in_units(const WrittenAxis& axis, double si) {
  std::string text = in_units(axis, si);
  if (read_back(text) / axis.units_per_si != si) return std::nullopt;
  return text;
}

std::size_t cell_count(const Grid& grid) {
  std::size_t cells = grid.speed_hz.size() * grid.unbalance.size();
  for (const KeyAxis& axis : grid.axes) cells *= axis.values.size();
  return cells;
}

std::vector<std::string> key_names(const Grid& grid) {
  std::vector<std::string> names;
  for (const KeyAxis& axis : grid.axes) names.insert(names.end(), axis.keys.begin(), axis.keys.end());
  return names;
}

std::vector<KeyValue> key_values(const Grid& grid, std::size_t cell) {
  std::vector<KeyValue> values;
  std::size_t place = cell / grid.speed_hz.size() / grid.unbalance.size();
  for (const KeyAxis& axis : grid.axes) {
    const double value = axis.values[place % axis.values.size()];
    place /= axis.values.size();
    for (KeyValue& key : keys_at(axis, value)) values.push_back(std::move(key));
  }
  return values;
}

std::vector<KeyValue> columns_of_place(const Grid& grid, std::size_t cell) {
  const std::size_t speeds = grid.speed_hz.size();
  std::vector<KeyValue> columns{
      {"speed_hz", grid.speed_hz[cell % speeds]},
      {std::string(to_string(grid.measure)), grid.unbalance[cell / speeds % grid.unbalance.size()]}};
  for (KeyValue& key : key_values(grid, cell)) columns.push_back(std::move(key));
  return columns;
}

std::vector<SweptAxis> swept_axes(const Grid& grid) {
  std::vector<SweptAxis> swept;
  if (grid.speed_hz.size() > 1) swept.push_back({"speed_hz", grid.speed_hz});
  if (grid.unbalance.size() > 1) swept.push_back({std::string(to_string(grid.measure)), grid.unbalance});
  for (const KeyAxis& axis : grid.axes) {
    if (axis.values.size() > 1) swept.push_back({axis.keys.front(), axis.values});
  }
  return swept;
}

std::optional<std::string> disordered_axis(const Grid& grid) {
  for (SweptAxis& axis : swept_axes(grid)) {
    const auto& values = axis.values;
    const bool rises = std::ranges::is_sorted(values),
               falls = std::ranges::is_sorted(values, std::greater<>());
    if (!rises && !falls) return std::move(axis.name);
  }
  return std::nullopt;
}

scene::Unbalance unbalance_of(const Grid& grid, double value) {
  switch (grid.measure) {
    case UnbalanceMeasure::whirl_ratio: return scene::WhirlRatio{value};
    case UnbalanceMeasure::eccentricity_m: return scene::Eccentricity{value};
  }
  throw SolverError("measure of the unbalance without a meaning");
}

scene::Place place_of(const Grid& grid, std::size_t cell) {
  const std::size_t speeds = grid.speed_hz.size();
  return {grid.speed_hz[cell % speeds],
          unbalance_of(grid, grid.unbalance[cell / speeds % grid.unbalance.size()])};
}

Grid grid_of(const scene::Place& place) {
  return std::visit(
      overloaded{[&](const scene::WhirlRatio& ratio) {
                   return Grid{{place.speed_hz}, UnbalanceMeasure::whirl_ratio, {ratio.value}};
                 },
                 [&](const scene::Eccentricity& eccentricity) {
                   return Grid{{place.speed_hz}, UnbalanceMeasure::eccentricity_m, {eccentricity.value_m}};
                 }},
      place.unbalance);
}

}  // namespace rubsweep::sweep
