#pragma once

/// \file
/// One cell of a map: a machine at one speed and unbalance, on its quiet whirl, ready to be run. The
/// unbalance is an eccentricity in metres, or the whirl ratio, which is the largest excursion of the quiet
/// whirl towards the first stop over the clearance there. Throws ConfigError for a machine that is not
/// valid.
///
/// scene::Cell has the scene to run, the closed form of the quiet motion, both measures of the unbalance, and
/// `start`. scene::can_run(cell.start) is false where static forces leave no clearance or no unbalance gives
/// the ratio. Where many cells share a machine, scene::prepare_machine does once all work that depends on
/// neither speed nor unbalance.
///
/// ```cpp
/// using namespace rubsweep;
/// const config::RunConfig config = config::read_run_config("configs/minimal.yaml", {});
/// const auto prepared = scene::prepare_machine(config.study.machine);
/// for (const double speed_hz : {50.0, 60.0, 70.0}) {
///   const auto cell = scene::build_cell(prepared, speed_hz, scene::WhirlRatio{0.2});
///   std::printf("%g Hz: eccentricity %.4g mm\n", speed_hz, 1e3 * cell.eccentricity_m);
/// }
/// ```

#include "rubsweep/core/scene/build_scene.hpp"
