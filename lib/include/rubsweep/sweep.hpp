#pragma once

/// \file
/// Cells of a map in memory. sweep::Study has the machine and the grid: axes of speed (Hz) and unbalance, and
/// optional axes over keys. Cells are numbered along the speed first. run_cells computes the listed cells on
/// `threads` threads (0: all processors), hands over each sweep::Row as it is finished, one at a time, in any
/// order, and returns how many finished. A row has the columns of map.csv in SI units, empty where they do
/// not apply; `status` is ok or the reason of a failure. An exception thrown by `on_row` ends the run.
///
/// ```cpp
/// using namespace rubsweep;
/// const sweep::Study study =
///     config::read_run_config("configs/minimal.yaml", {"sweep.speed_hz={values: [60, 70]}",
///                                                      "sweep.whirl_ratio={values: [0.2]}"})
///         .study;
/// const std::vector<std::size_t> cells{0, 1};
/// const std::atomic<bool> stop = false;
/// sweep::run_cells(
///     study, cells, 1,
///     [&](std::size_t, const sweep::Row& row) {
///       std::printf("%g Hz: %s\n", row.speed_hz, sweep::class_and_order(row).c_str());
///     },
///     stop);
/// ```

#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
