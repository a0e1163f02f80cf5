#pragma once

/// \file
/// A run-up or run-down through rub: the shaft speed changes at a constant rate, with an unbalance and all
/// stops. Speeds are in Hz, the rate in Hz/s, negative for a run-down. run_ramp passes on one stretch after
/// another with the chosen number of samples, and returns how the run ended. Throws ConfigError where no ramp
/// is possible: faulty bearings, static forces that press the rotor through a wall, no quiet motion.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study = config::read_run_config("configs/minimal.yaml", {}).study;
/// const auto prepared = scene::prepare_machine(study.machine);
/// double peak_m = 0;
/// ramp::run_ramp(prepared, {.from_hz = 20, .to_hz = 40, .rate_hz_per_s = 10, .eccentricity_m = 5e-5},
///                study.solver, 64, [&](const ramp::RampStretch& stretch) {
///                  peak_m = std::max(peak_m, stretch.peak_displacement_m);
///                });
/// std::printf("largest displacement %.3g mm\n", 1e3 * peak_m);
/// ```

#include "rubsweep/analysis/ramp/ramp_run.hpp"
