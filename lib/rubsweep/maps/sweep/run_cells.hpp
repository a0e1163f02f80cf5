#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// As the other `run_cells`, where study.machine is prepared already, which of a rotor kit takes as long as a
/// hundred cells.
std::size_t run_cells(const Study& study, const scene::PreparedMachine& prepared,
                      std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop);

}  // namespace rubsweep::sweep
