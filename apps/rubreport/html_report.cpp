#include "rubreport/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <utility>
#include <vector>

#include "explain/explain_study.hpp"
#include "rubreport/findings.hpp"
#include "rubreport/page.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"

namespace rubsweep::apps {

using namespace page;

namespace {

/// Axes of the drawn plane: speed and unbalance, or the two axes with several values where keys are swept.
std::array<sweep::SweptAxis, 2> plane_of(const sweep::Grid& grid) {
  const sweep::SweptAxis speed{"speed_hz", grid.speed_hz},
      unbalance{std::string(to_string(grid.measure)), grid.unbalance};
  const std::vector<sweep::SweptAxis> swept = sweep::swept_axes(grid);
  if (grid.axes.empty() || swept.empty()) return {speed, unbalance};
  if (swept.size() == 1) return {swept[0], swept[0].name == speed.name ? unbalance : speed};
  report::require_plane(grid, "a report");
  return {swept.at(0), swept.at(1)};
}

/// Units and spacing in which the axis of this column was written.
sweep::WrittenAxis written_axis(const sweep::Grid& grid, const std::string& column) {
  if (column == "speed_hz") return grid.written_speed;
  if (column == to_string(grid.measure)) return grid.written_unbalance;
  sweep::WrittenAxis axis;
  for (const sweep::KeyAxis& swept : grid.axes)
    if (swept.keys.front() == column) axis.spacing = swept.spacing;
  return axis;
}

/// At most `most` of the `cells`, spread evenly.
std::vector<std::size_t> some_of(const std::vector<std::size_t>& cells, std::size_t most) {
  if (cells.size() <= most) return cells;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(cells[i * cells.size() / most]);
  return some;
}

/// Adds sentences on a refined map.
void add_refinement(const sweep::Grid& grid, const std::vector<int>& labels, std::vector<std::string>& said) {
  std::istringstream lines(report::describe_refinement(grid, labels));
  std::size_t at = 1;  // position behind the sentence on the size of the map
  for (std::string line; std::getline(lines, line); ++at) {
    line.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(line.front())));
    said.insert(said.begin() + static_cast<std::ptrdiff_t>(at), line + ".");
  }
}

ThinnedGrid kept_of(const sweep::Grid& grid, std::size_t most) {
  const auto plane = plane_of(grid);
  return thinned_grid(plane[0].values.size(), plane[1].values.size(), most);
}

}  // namespace

std::size_t recorded_cells(const sweep::Grid& grid, const MapTable& map, std::size_t most_orbits) {
  return grid.refinement ? std::min(map.rows, most_orbits) : kept_of(grid, most_orbits).cells().size();
}

std::optional<std::string> report_page(const sweep::Study& study, MapTable map,
                                       const std::filesystem::path& directory, const PageOptions& options,
                                       const std::function<void()>& on_cell, const std::atomic<bool>& stop) {
  const sweep::Grid& grid = study.grid;
  PaintedTable painted;
  if (grid.refinement) {
    painted = painted_table(map, grid);
    map = std::move(painted.map);
  }
  if (map.rows != sweep::cell_count(grid)) {
    throw IoError(fmt::format("{}: holds {} cells, its configuration has {}",
                              (directory / "map.csv").string(), map.rows, sweep::cell_count(grid)));
  }
  PageContents contents{
      .version = options.version,
      .findings = findings(map, grid),
      .model = explain_study(study),
      .configuration = options.configuration,
      .plane = plane_of(grid),
      .written = {written_axis(grid, plane_of(grid)[0].name), written_axis(grid, plane_of(grid)[1].name)},
      .captions = options.captions,
      .unbalance_measure = std::string(to_string(grid.measure)),
      .keys = sweep::key_names(grid),
      .map = {},
      .walls = walls_of(study),
      .boundaries = {},
      .orbits = {},
      .kept = kept_of(grid, options.most_orbits),
      .refined = grid.refinement.has_value()};
  if (contents.refined) add_refinement(grid, painted.labels, contents.findings);
  // Boundaries are lines over speed and unbalance.
  if (grid.axes.empty())
    contents.boundaries = read_boundaries(directory / "boundaries.csv", to_string(grid.measure), map.digest);
  std::vector<std::size_t> cells =
      contents.refined ? some_of(painted.computed, options.most_orbits) : contents.kept.cells();
  auto orbits = record_orbits(study, map, std::move(cells), options.threads, on_cell, stop);
  if (!orbits) return std::nullopt;
  contents.map = std::move(map);
  contents.orbits = std::move(*orbits);
  return page_text(contents);
}

}  // namespace rubsweep::apps
