#pragma once

/// \file
/// One run, from the kick to the motion on which it settles. response::settle takes a cell (cell.hpp) that
/// can run, options of the solver and of the classification (defaults: those of a sweep), and a workspace.
/// The workspace keeps what the next run can use again; each thread needs its own. A run that fails throws
/// nothing: `outcome` says how it ended, and the class is then `failed`.
///
/// The result has the motion (motion.hpp), the evidence for it (`proof`), the number of revolutions, and
/// `section`, the scaled state at the end: 2n numbers, first displacements over the length scale of the
/// scene, then rates.
///
/// ```cpp
/// using namespace rubsweep;
/// const config::RunConfig config = config::read_run_config("configs/minimal.yaml", {});
/// const auto cell = scene::build_cell(config.study.machine, 70, scene::WhirlRatio{0.2});
/// response::motion::Workspace workspace;
/// const auto run = response::settle(cell, config.study.solver, config.study.response, workspace);
/// if (run.outcome == integrate::run::Outcome::ok) std::printf("%ld revolutions\n", run.revolutions);
/// ```

#include "rubsweep/core/response/settle.hpp"
