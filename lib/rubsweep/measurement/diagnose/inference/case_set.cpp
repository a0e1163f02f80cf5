#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Draws simulated as one batch. Drawing ends only after a whole batch, so the number of threads does not
/// change the result.
constexpr int draws_together = 128;

Point prior_point(const DiagnosisProblem& problem, std::size_t candidate, long draw) {
  constexpr std::uint64_t most_draws = 1U << 24;
  RandomStream random(problem.seed, candidate * most_draws + static_cast<std::uint64_t>(draw),
                      DrawPurpose::of_prior);
  Point unit{};
  for (double& place : unit) place = random.uniform();
  return unit;
}

/// Simulates draws and keeps the successful ones as cases, in the order of the draws.
void simulate_draws(const DiagnosisProblem& problem, std::size_t candidate, long before,
                    const CaseOptions& options, std::vector<SimulatedCase>& cases) {
  std::vector<std::optional<SimulatedCase>> simulated(draws_together);
  const std::atomic<bool> go_on{false};
  batch::parallel_run(
      simulated.size(), options.threads,
      [&](std::size_t k) {
        thread_local response::spectrum::SpectrumWorkspace workspace;
        simulated[k] = simulate_case(
            problem, candidate, prior_point(problem, candidate, before + static_cast<long>(k)), workspace);
      },
      {}, options.stop ? *options.stop : go_on);
  for (auto& one : simulated)
    if (one) cases.push_back(*std::move(one));
}

bool stopped(const CaseOptions& options) { return options.stop && *options.stop; }

}  // namespace

CaseSet prior_cases(const DiagnosisProblem& problem, const CaseOptions& options) {
  const std::size_t candidates = problem.candidates.size();
  const auto wanted = static_cast<std::size_t>(options.cases_per_candidate);
  const long most = static_cast<long>(options.most_draws_per_case) * options.cases_per_candidate;
  std::vector<std::vector<SimulatedCase>> cases(candidates);
  std::vector<long> drawn(candidates, 0);
  const auto unfinished = [&](std::size_t c) { return cases[c].size() < wanted && drawn[c] < most; };
  // Candidates get their batches in turn, so that an interrupted set has cases of all of them.
  for (bool any = true; any && !stopped(options);) {
    any = false;
    for (std::size_t c = 0; c < candidates; ++c) {
      if (!unfinished(c) || stopped(options)) continue;
      simulate_draws(problem, c, drawn[c], options, cases[c]);
      drawn[c] += draws_together;
      any = true;
      if (!options.on_cases) continue;
      std::size_t done = 0;
      for (std::size_t k = 0; k < candidates; ++k) done += unfinished(k) ? cases[k].size() : wanted;
      options.on_cases(done, wanted * candidates);
    }
  }
  CaseSet set;
  for (auto& of_candidate : cases) std::ranges::move(of_candidate, std::back_inserter(set.cases));
  return set;
}

Eigen::VectorXd prior_weights(const DiagnosisProblem& problem, const CaseSet& set) {
  std::vector<double> count(problem.candidates.size(), 0.0);
  for (const SimulatedCase& one : set.cases) ++count[one.candidate];
  Eigen::VectorXd weight(static_cast<Eigen::Index>(set.cases.size()));
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    weight(i) = 1 / count[set.cases[static_cast<std::size_t>(i)].candidate];
  return weight;
}

}  // namespace rubsweep::diagnose::inference
