#pragma once

#include <cstddef>

#include "rubsweep/response/full_spectrum.hpp"
#include "rubsweep/scene/plan.hpp"
#include "rubsweep/sweep/row.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::sweep {

/// Cells of the grid, speed fastest: cell = i_unbalance * speeds + i_speed.
std::size_t cell_count(const Grid& grid);

/// Runs one cell from kick to verdict. Depends on its arguments alone, so that any thread may run any cell.
/// A cell that fails numerically is a row of class `failed` whose status names the cause.
/// `plan` is that of study.machine.
Row evaluate_cell(const Study& study, const scene::Plan& plan, std::size_t cell,
                  response::Workspace& workspace);

/// The same for a single cell, with a plan of its own.
Row evaluate_cell(const Study& study, std::size_t cell, response::Workspace& workspace);

}  // namespace rubsweep::sweep
