#pragma once

/// \file
/// The linear rotor, without its stops: whirl modes over the speed, critical speeds, stability and mode
/// shapes, from the full matrices. Speeds and frequencies are in Hz, growth rates in 1/s; damping is a ratio
/// of critical damping, negative where unstable. Throws ConfigError for a speed outside the tables of the
/// bearings.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study = config::read_run_config("configs/reference/rotor_kit.yaml", {}).study;
/// const std::vector<double> speeds_hz{1, 50, 100, 150};
/// const auto rotor = linear::free_rotor(study.machine);
/// const auto diagram = linear::campbell(rotor, speeds_hz, 200);
/// for (const auto& critical : diagram.critical_speeds)
///   std::printf("mode %d: %g Hz\n", critical.mode, critical.speed_hz);
/// ```

#include "rubsweep/analysis/linear/campbell.hpp"
