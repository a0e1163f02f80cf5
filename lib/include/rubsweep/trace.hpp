#pragma once

/// \file
/// One run in detail: the trajectory at equal angles, the state after each turn, every change of contact mode
/// with its instant, probes, and contacts turn by turn. Displacements are in metres, times in seconds since
/// the start of the kick. trace_run takes a run at its start (integrate::start), its scene, and the numbers
/// of turns and samples. A run that fails ends early, and `outcome` says why.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study = config::read_run_config("configs/minimal.yaml", {}).study;
/// const auto cell = scene::build_cell(study.machine, 70, scene::WhirlRatio{0.2});
/// response::motion::Workspace workspace;
/// const auto run = integrate::start(cell.scene, study.solver, workspace.modes);
/// const auto trace = trace::trace_run(
///     run.advance, cell.scene, study.solver,
///     {.speed_hz = 70, .revolutions = 20, .samples_per_revolution = 64, .window_revolutions = 10});
/// std::printf("%zu states, %zu changes of contact\n", trace.trajectory.size(), trace.switches.size());
/// ```

#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
