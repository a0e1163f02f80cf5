#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

namespace rubsweep {

/// A machine with its speed and instrument. Half of the recordings have a reading every millisecond, a third
/// have a single probe.
struct StudiedMachine {
  double frequency_hz = 0, damping_ratio = 0, speed_ratio = 0;
  double sampling_rate_hz = 0;
  int probes = 2;
};

/// Draws the machine with this number from the priors.
StudiedMachine draw_studied(std::size_t machine, std::mt19937_64& random);

/// Study of rubdata that records this machine with the stops of one cause.
dataset::DataStudy study_of(const StudiedMachine& machine, diagnose::Cause cause, std::uint64_t seed);

/// Diagnosis problem in which the machine is known as well as from a fit: 1 % of the frequency, 20 % of the
/// damping.
diagnose::inference::DiagnosisProblem problem_of(const StudiedMachine& machine, std::uint64_t seed,
                                                 std::mt19937_64& random);

}  // namespace rubsweep
