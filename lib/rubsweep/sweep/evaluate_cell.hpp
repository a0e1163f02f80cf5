#pragma once

#include <cstddef>

#include "rubsweep/response/spectrum/full_spectrum.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/row.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::sweep {

/// Runs one cell from kick to verdict. Depends on its arguments alone, so that any thread may run any cell.
/// A cell that fails numerically is a row of class `failed` whose status names the cause.
/// `prepared` is that of study.machine.
Row evaluate_cell(const Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                  response::motion::Workspace& workspace);

/// The same for a single cell, with a prepared machine of its own.
Row evaluate_cell(const Study& study, std::size_t cell, response::motion::Workspace& workspace);

}  // namespace rubsweep::sweep
