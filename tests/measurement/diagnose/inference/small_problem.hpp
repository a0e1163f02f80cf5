#pragma once

#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

namespace rubsweep::diagnose::inference {

/// A problem with two candidates, no rub or one flat stop that is a spring, on a known machine at twice its
/// natural frequency.
inline DiagnosisProblem small_problem() {
  DiagnosisProblem problem;
  problem.candidates = {usual_candidate(Cause::no_rub), usual_candidate(Cause::one_side)};
  for (Candidate& candidate : problem.candidates) {
    spread_of(candidate, Unknown::natural_frequency) = {30, 30.3, false};
    spread_of(candidate, Unknown::damping_ratio) = {0.018, 0.022, false};
    spread_of(candidate, Unknown::exponent) = {1, 1, false};
    candidate.clearance_m = {5e-5, 1e-3, true};
  }
  problem.prior = {0.5, 0.5};
  problem.speed_hz = 66;
  problem.turns = 12;
  problem.measuring.readings_per_turn = 80;
  return problem;
}

inline CaseOptions few_cases(int threads = 0) {
  CaseOptions options;
  options.cases_per_candidate = 25;
  options.threads = threads;
  return options;
}

/// Cases drawn from the priors, simulated once for all tests.
inline const CaseSet& small_set() {
  static const CaseSet set = prior_cases(small_problem(), few_cases());
  return set;
}

/// A case outside the set, as it would be recorded.
inline features::DescribedMotion recorded_case(std::size_t candidate, std::uint64_t seed) {
  const DiagnosisProblem problem = small_problem();
  response::spectrum::SpectrumWorkspace workspace;
  for (std::uint64_t k = 0;; ++k) {
    RandomStream random(seed, k, 1000);
    Point unit{};
    for (double& place : unit) place = random.uniform();
    if (const auto one = simulate_case(problem, candidate, unit, workspace))
      return observe(problem, *one, 1'000'000 + seed, workspace).seen;
  }
}

}  // namespace rubsweep::diagnose::inference
