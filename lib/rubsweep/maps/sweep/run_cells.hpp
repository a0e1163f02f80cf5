#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Evaluates the cells listed in `cells` on `threads` threads (0: all processors) and returns how many
/// finished. `on_row` gets each row as it is finished, one at a time, in any order; a row depends on its cell
/// alone, and no row is kept. What on_row throws ends the run. Once `stop` is true no new cell starts.
std::size_t run_cells(const Study& study, std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop);

}  // namespace rubsweep::sweep
