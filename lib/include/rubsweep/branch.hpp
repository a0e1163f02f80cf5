#pragma once

/// \file
/// A branch of periodic orbits, stable or unstable, by pseudo-arclength continuation. settle_on_orbit runs a
/// cell until it reaches its orbit. closed_orbits states the problem for scenes over a parameter, and
/// orbit_from finds the orbit by Newton's iteration. follow_both_ways follows the branch through its folds
/// and locates folds, doublings, Neimark-Sacker points and grazes. branch_csv and branch_events_csv write the
/// tables of `rubbranch`. An empty result means that there is nothing to follow.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study = config::read_run_config("configs/minimal.yaml", {}).study;
/// const auto prepared = scene::prepare_machine(study.machine);
/// const scene::Eccentricity unbalance{
///     scene::build_cell(prepared, 70, scene::WhirlRatio{0.2}).eccentricity_m};
/// const auto cell = [&](double speed_hz) { return scene::build_cell(prepared, speed_hz, unbalance); };
/// response::motion::Workspace workspace;
/// const auto settled =
///     branch::orbits::settle_on_orbit(cell(70), study.solver, study.response, workspace);
/// auto problem = branch::orbits::closed_orbits(
///     settled.closing, [&](double speed_hz) { return cell(speed_hz).scene; }, settled.order.value(),
///     study.solver, workspace.modes);
/// problem.low = 65, problem.high = 75, problem.parameter_scale = 10;
/// const auto start = branch::continuation::orbit_from(problem, settled.state, 70);
/// const auto found = branch::continuation::follow_both_ways(problem, start.value(), {});
/// std::puts(branch::continuation::branch_summary("speed_hz", {found}).c_str());
/// ```

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
