#pragma once

/// \file
/// A line of cells. Each cell starts from its kick, or from the motion of the cell before it, upwards or
/// downwards, which shows where one motion is lost and another found (hysteresis). Cells share studies and
/// prepared machines. follow_line hands over each point with its row (sweep.hpp) and its settled motion, one
/// at a time, in any order; the results do not depend on `threads`. Throws ConfigError where neighbours have
/// different numbers of coordinates.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study =
///     std::make_shared<sweep::Study>(config::read_run_config("configs/minimal.yaml", {}).study);
/// const auto machine = std::make_shared<scene::PreparedMachine>(scene::prepare_machine(study->machine));
/// std::vector<line::LineCell> cells;
/// for (const double speed_hz : {60.0, 65.0, 70.0})
///   cells.push_back({speed_hz, study, machine, {speed_hz, scene::WhirlRatio{0.2}}});
/// const std::atomic<bool> stop = false;
/// line::follow_line(
///     cells, std::array{line::Pass::up}, 1,
///     [](line::LinePoint&& point) {
///       std::printf("%g Hz: %s\n", point.row.speed_hz, sweep::class_and_order(point.row).c_str());
///     },
///     stop);
/// ```

#include "rubsweep/analysis/line/follow_line.hpp"
