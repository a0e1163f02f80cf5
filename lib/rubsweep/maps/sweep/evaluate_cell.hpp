#pragma once

#include <cstddef>

#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Row of a cell of `machine` at a speed, from its settled run; `run` is null where the cell could not run.
Row row_of(const scene::Cell& cell, double speed_hz, const model::Machine& machine,
           const response::SettledRun* run);

/// Runs one cell from kick to classification. The result depends on the arguments alone, so that any thread
/// may run any cell. A cell with a numerical failure gives a row of class `failed`, whose status names the
/// cause. `prepared` is the prepared study.machine.
Row evaluate_cell(const Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                  response::motion::Workspace& workspace);

/// Runs a single cell, and prepares the machine for it.
Row evaluate_cell(const Study& study, std::size_t cell, response::motion::Workspace& workspace);

}  // namespace rubsweep::sweep
