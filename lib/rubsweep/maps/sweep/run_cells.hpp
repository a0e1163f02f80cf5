#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Evaluates the cells listed in `cells` on `threads` threads (0: all processors) and returns how many
/// finished. `on_row` gets each finished row, one at a time, in any order. A row depends on its cell alone,
/// and no row is kept. An exception in on_row ends the run. Once `stop` is true no new cell starts.
std::size_t run_cells(const Study& study, std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop);

/// The same for a study.machine that is already prepared; preparing a rotor kit takes as long as a hundred
/// cells.
std::size_t run_cells(const Study& study, const scene::PreparedMachine& prepared,
                      std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop);

}  // namespace rubsweep::sweep
