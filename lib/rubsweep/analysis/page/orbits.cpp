#include "rubsweep/analysis/page/orbits.hpp"

#include <algorithm>
#include <utility>

#include "rubsweep/analysis/page/compressed.hpp"
#include "rubsweep/analysis/page/encode_orbit.hpp"
#include "rubsweep/analysis/page/settled_orbit.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::page {
namespace {

/// How many of `count` values are left at a stride.
std::size_t left(std::size_t count, std::size_t stride) {
  const std::size_t first = stride / 2;
  return first < count ? (count - first - 1) / stride + 1 : 0;
}

thread_local response::motion::Workspace orbit_workspace;

KnownMotion known_motion(const MapTable& map, std::size_t row) {
  KnownMotion known{map.word("class", row), std::nullopt, 0, false};
  if (const auto order = map.number("order", row)) known.order = static_cast<int>(*order);
  known.revolutions = static_cast<long>(map.number("revolutions", row).value_or(0));
  known.proven = map.word("proof", row).starts_with("floquet");
  known.hertz_force_n = map.number("hertz_force_n", row);
  return known;
}

std::vector<Wall> walls_of(const model::Machine& machine, double speed_hz) {
  const scene::Cell cell = scene::build_cell(machine, speed_hz, scene::Eccentricity{0});
  std::vector<Wall> walls;
  for (const scene::Contact& contact : cell.scene.contacts) {
    const contact::Outline outline = contact::outline(contact.wall);
    walls.push_back({.around = outline.around,
                     .normal = {outline.normal.x(), outline.normal.y()},
                     .centre_m = {outline.centre.x(), outline.centre.y()},
                     .clearance_m = contact.clearance_m,
                     .at_orbit = contact.rotor_point == cell.scene.observed_point});
  }
  return walls;
}

}  // namespace

std::vector<std::size_t> ThinnedGrid::cells() const {
  std::vector<std::size_t> kept;
  for (std::size_t j = unbalance_stride / 2; j < unbalances; j += unbalance_stride)
    for (std::size_t i = speed_stride / 2; i < speeds; i += speed_stride) kept.push_back(j * speeds + i);
  return kept;
}

ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most) {
  ThinnedGrid grid{speeds, unbalances};
  while (left(speeds, grid.speed_stride) * left(unbalances, grid.unbalance_stride) > most) {
    // The axis that is still denser gives way, but never its last value.
    const bool speed = left(unbalances, grid.unbalance_stride) == 1 ||
                       (grid.speed_stride <= grid.unbalance_stride && left(speeds, grid.speed_stride) > 1);
    ++(speed ? grid.speed_stride : grid.unbalance_stride);
  }
  return grid;
}

std::optional<Orbits> record_orbits(const sweep::Study& study, const MapTable& map,
                                    std::vector<std::size_t> cells, int threads,
                                    const std::function<void()>& on_cell, const std::atomic<bool>& stop) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::vector<std::string> records(cells.size());
  const std::size_t finished = batch::parallel_run(
      cells.size(), threads,
      [&](std::size_t i) {
        const auto orbit =
            settled_orbit(study, prepared, cells[i], known_motion(map, cells[i]), orbit_workspace);
        if (orbit) records[i] = encode_orbit(cells[i], *orbit);
      },
      [&](std::size_t) { on_cell(); }, stop);
  if (finished != cells.size()) return std::nullopt;

  Orbits orbits{std::move(cells), 0, {}};
  for (std::size_t begin = 0; begin < records.size(); begin += cells_per_block) {
    std::string block;
    for (std::size_t i = begin; i < std::min(begin + cells_per_block, records.size()); ++i) {
      if (!records[i].empty()) ++orbits.recorded;
      block += records[i];
    }
    orbits.blocks.push_back(compressed(block));
  }
  return orbits;
}

Walls walls_of(const sweep::Study& study) {
  const sweep::Grid& grid = study.grid;
  const double speed_hz = grid.speed_hz.front();
  if (grid.axes.empty()) return {{walls_of(study.machine, speed_hz)}, {0}};
  Walls walls;
  const std::size_t plane = grid.speed_hz.size() * grid.unbalance.size();
  for (std::size_t cell = 0; cell < sweep::cell_count(grid); cell += plane) {
    std::vector<Wall> list;
    try {
      list = walls_of(study.with_keys(sweep::key_values(grid, cell)).machine, speed_hz);
    } catch (const ConfigError&) {
      list.clear();
    }
    const auto known = std::ranges::find(walls.lists, list);
    walls.list_of_keys.push_back(static_cast<std::size_t>(known - walls.lists.begin()));
    if (known == walls.lists.end()) walls.lists.push_back(std::move(list));
  }
  return walls;
}

}  // namespace rubsweep::page
