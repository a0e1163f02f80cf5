#include "rubsweep/analysis/branch/families/quiet_cells.hpp"

#include <cstddef>
#include <numbers>

#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::branch::families {

std::vector<Quiet> quiet_cells(const sweep::Study& study) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::vector<bool> grows;
  for (const double speed_hz : study.grid.speed_hz)
    grows.push_back(structure::grows(prepared.assembly, 2 * std::numbers::pi * speed_hz));
  std::vector<Quiet> cells;
  for (const double unbalance : study.grid.unbalance) {
    for (std::size_t i = 0; i < grows.size(); ++i) {
      const scene::Cell cell =
          scene::build_cell(prepared, study.grid.speed_hz[i], sweep::unbalance_of(study.grid, unbalance));
      cells.push_back(cell.start != scene::Start::quiet ? Quiet::touches
                      : grows[i]                        ? Quiet::unstable
                                                        : Quiet::stable);
    }
  }
  return cells;
}

}  // namespace rubsweep::branch::families
