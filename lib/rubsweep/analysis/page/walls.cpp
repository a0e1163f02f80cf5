#include "rubsweep/analysis/page/walls.hpp"

#include <algorithm>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::page {
namespace {

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
