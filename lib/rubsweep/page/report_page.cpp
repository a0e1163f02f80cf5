#include "rubsweep/page/report_page.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "rubsweep/error.hpp"
#include "rubsweep/page/findings.hpp"
#include "rubsweep/page/page.hpp"
#include "rubsweep/report/explain_study.hpp"

namespace rubsweep::page {
namespace {

/// Speed and unbalance, or the two axes with several values where keys are swept.
std::array<sweep::SweptAxis, 2> plane_of(const sweep::Grid& grid) {
  const sweep::SweptAxis speed{"speed_hz", grid.speed_hz},
      unbalance{std::string(to_string(grid.measure)), grid.unbalance};
  const std::vector<sweep::SweptAxis> swept = sweep::swept_axes(grid);
  if (grid.axes.empty() || swept.empty()) return {speed, unbalance};
  if (swept.size() == 1) return {swept[0], swept[0].name == speed.name ? unbalance : speed};
  if (swept.size() == 2) return {swept[0], swept[1]};
  std::string names;
  for (const sweep::SweptAxis& axis : swept) names += (names.empty() ? "" : ", ") + axis.name;
  throw ConfigError(
      fmt::format("sweep: {} have several values, allowed: two axes with several values in a report", names));
}

}  // namespace

std::optional<std::string> report_page(const sweep::Study& study, MapTable map,
                                       const std::filesystem::path& directory, const PageOptions& options,
                                       const std::function<void()>& on_cell, const std::atomic<bool>& stop) {
  const sweep::Grid& grid = study.grid;
  if (map.rows != sweep::cell_count(grid)) {
    throw IoError(fmt::format("{}: holds {} cells, its configuration has {}",
                              (directory / "map.csv").string(), map.rows, sweep::cell_count(grid)));
  }
  PageContents contents{.version = options.version,
                        .findings = findings(map, grid),
                        .model = report::explain_study(study),
                        .configuration = options.configuration,
                        .plane = plane_of(grid),
                        .unbalance_measure = std::string(to_string(grid.measure)),
                        .keys = sweep::key_names(grid),
                        .map = {},
                        .walls = walls_of(study),
                        .boundaries = {},
                        .orbits = {}};
  // They lie over speed and unbalance.
  if (grid.axes.empty())
    contents.boundaries = read_boundaries(directory / "boundaries.csv", to_string(grid.measure));
  const ThinnedGrid kept =
      thinned_grid(contents.plane[0].values.size(), contents.plane[1].values.size(), options.most_orbits);
  auto orbits = record_orbits(study, map, kept, options.threads, on_cell, stop);
  if (!orbits) return std::nullopt;
  contents.map = std::move(map);
  contents.orbits = std::move(*orbits);
  return page_text(contents);
}

}  // namespace rubsweep::page
