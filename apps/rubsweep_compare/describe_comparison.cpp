#include "describe_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace rubsweep::apps {
namespace {

std::string place(const MapComparison& comparison, const ComparedCell& cell) {
  std::string text = fmt::format("speed_hz {}, {} {}", cell.speed_hz, comparison.axis, cell.unbalance);
  for (std::size_t i = 0; i < cell.keys.size(); ++i)
    text += fmt::format(", {} {}", comparison.keys[i], cell.keys[i]);
  return text;
}

/// Number of cells with this result, and the names of the first twenty.
std::string list_cells(const MapComparison& comparison, CellVerdict verdict) {
  constexpr std::size_t longest = 20;
  std::string text;
  std::size_t listed = 0;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.verdict != verdict || ++listed > longest) continue;
    const auto shown = [](const std::string& label) { return label.empty() ? "no such cell" : label; };
    text +=
        fmt::format("  {}: {} -> {}\n", place(comparison, cell), shown(cell.label_a), shown(cell.label_b));
  }
  if (listed > longest) text += fmt::format("  ... and {} more\n", listed - longest);
  return text;
}

std::string list_columns(const MapComparison& comparison) {
  std::string text;
  for (const ColumnDifference& column : comparison.columns) {
    const std::string size = column.largest ? fmt::format("largest {:.2g}", *column.largest) : "first";
    text += fmt::format("  {}: {} cells, {} at {}: {} -> {}\n", column.column, column.cells, size,
                        place(comparison, comparison.cells[column.cell]),
                        column.a.empty() ? "empty" : column.a, column.b.empty() ? "empty" : column.b);
  }
  return text;
}

}  // namespace

std::string describe_comparison(const MapComparison& comparison, double tolerance) {
  std::string text;
  if (comparison.digest_a != comparison.digest_b) {
    text += fmt::format("digests: {} and {}, two studies\n", comparison.digest_a, comparison.digest_b);
  }
  const auto count = [&](CellVerdict verdict) { return comparison.count(verdict); };
  const auto changed = std::ranges::count_if(comparison.cells, [](const ComparedCell& cell) {
    return cell.verdict == CellVerdict::sensitive && cell.label_a != cell.label_b;
  });
  text += fmt::format(
      "{} cells: {} equal, {} with another class, {} with other numbers (beyond {}), {} in one map only\n",
      comparison.cells.size(), count(CellVerdict::equal), count(CellVerdict::classes_differ),
      count(CellVerdict::numbers_differ), tolerance, count(CellVerdict::only_in_one));
  if (count(CellVerdict::sensitive) > 0) {
    text += fmt::format("not compared: {} sensitive cells, {} of them with another class\n",
                        count(CellVerdict::sensitive), changed);
  }
  if (!comparison.missing_columns.empty()) {
    text += fmt::format("not compared: {}, which only one of the maps has\n",
                        fmt::join(comparison.missing_columns, ", "));
  }
  text += list_cells(comparison, CellVerdict::classes_differ);
  text += list_columns(comparison);
  text += list_cells(comparison, CellVerdict::only_in_one);
  return text + (comparison.equal() ? "equal\n" : "different\n");
}

}  // namespace rubsweep::apps
