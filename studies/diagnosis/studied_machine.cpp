#include "studied_machine.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubsweep {
namespace {

using diagnose::Unknown;

/// Sets the intervals of the machine that a fit would leave: 1 % of the frequency, 20 % of the damping.
void tell_machine(const StudiedMachine& machine, std::vector<diagnose::Candidate>& candidates,
                  std::mt19937_64& random) {
  const auto about = [&](double truth, double half_width) {
    const double middle = truth * (1 + half_width * std::uniform_real_distribution<double>(-1, 1)(random));
    return diagnose::Spread{middle / (1 + half_width), middle * (1 + half_width), false};
  };
  const diagnose::Spread frequency = about(machine.frequency_hz, 0.01),
                         damping = about(machine.damping_ratio, 0.2);
  for (diagnose::Candidate& candidate : candidates) {
    spread_of(candidate, Unknown::natural_frequency) = frequency;
    spread_of(candidate, Unknown::damping_ratio) = damping;
    candidate.clearance_m = {5e-5, 1e-3, true};
  }
}

}  // namespace

StudiedMachine draw_studied(std::size_t machine, std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  StudiedMachine drawn{between(20, 60), 0.01 * std::pow(4, between(0, 1)), between(1.2, 4.5)};
  drawn.sampling_rate_hz = machine % 2 == 0 ? 10'000 : 1000;
  drawn.probes = machine % 3 == 2 ? 1 : 2;
  // A reading every millisecond is too slow for shafts faster than 100 Hz.
  if (drawn.sampling_rate_hz < 8 * drawn.speed_ratio * drawn.frequency_hz)
    drawn.speed_ratio = std::max(1.2, drawn.sampling_rate_hz / 8 / drawn.frequency_hz);
  return drawn;
}

dataset::DataStudy study_of(const StudiedMachine& machine, diagnose::Cause cause, std::uint64_t seed) {
  dataset::DataStudy study;
  study.seed = seed;
  study.recordings_per_machine = 1;
  study.fixed = {.rotor_mass_kg = 0.8, .contact_radius_m = 0.0375, .casing_damping_ratio = 0.1};
  study.candidates = {diagnose::usual_candidate(cause)};
  spread_of(study.candidates[0], Unknown::natural_frequency) = {machine.frequency_hz, machine.frequency_hz,
                                                                false};
  spread_of(study.candidates[0], Unknown::damping_ratio) = {machine.damping_ratio, machine.damping_ratio,
                                                            false};
  study.candidates[0].clearance_m = {5e-5, 1e-3, true};
  study.measurement.sampling_rate_hz = machine.sampling_rate_hz;
  study.measurement.probes = machine.probes;
  study.speed_ratio = {machine.speed_ratio, machine.speed_ratio, false};
  return study;
}

diagnose::inference::DiagnosisProblem problem_of(const StudiedMachine& machine, std::uint64_t seed,
                                                 std::mt19937_64& random) {
  diagnose::inference::DiagnosisProblem problem;
  problem.candidates = diagnose::usual_candidates();
  problem.prior.assign(problem.candidates.size(), 1.0 / static_cast<double>(problem.candidates.size()));
  problem.fixed = {.rotor_mass_kg = 0.8, .contact_radius_m = 0.0375, .casing_damping_ratio = 0.1};
  problem.speed_hz = machine.speed_ratio * machine.frequency_hz;
  problem.turns = 30;
  problem.measuring.probes = machine.probes;
  problem.measuring.readings_per_turn = machine.sampling_rate_hz / problem.speed_hz;
  problem.seed = seed;
  problem.measuring.natural_order = 1 / machine.speed_ratio;
  tell_machine(machine, problem.candidates, random);
  return problem;
}

}  // namespace rubsweep
