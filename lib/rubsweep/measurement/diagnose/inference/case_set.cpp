#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/measurement/diagnose/draw_purpose.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Draws that are simulated together: how many, not how many threads, decides where drawing ends.
constexpr int draws_together = 128;

/// Simulates draws and keeps those that give a case, in the order of the draws.
template <class Point_of>
void simulate_draws(const DiagnosisProblem& problem, std::size_t candidate, int count,
                    const Point_of& point_of, const CaseOptions& options, std::vector<SimulatedCase>& cases) {
  std::vector<std::optional<SimulatedCase>> simulated(static_cast<std::size_t>(count));
  const std::atomic<bool> go_on{false};
  batch::parallel_run(
      simulated.size(), options.threads,
      [&](std::size_t k) {
        thread_local response::spectrum::SpectrumWorkspace workspace;
        simulated[k] = simulate_case(problem, candidate, point_of(static_cast<long>(k)), workspace);
      },
      [](std::size_t) {}, options.stop ? *options.stop : go_on);
  for (auto& one : simulated)
    if (one) cases.push_back(*std::move(one));
}

/// Index of a random stream: draw number `draw` of a candidate in a round.
std::uint64_t stream_index(int round, std::size_t candidate, long draw) {
  constexpr std::uint64_t most_draws = 1U << 24, most_candidates = 64;
  return (static_cast<std::uint64_t>(round) * most_candidates + candidate) * most_draws +
         static_cast<std::uint64_t>(draw);
}

Point prior_point(const DiagnosisProblem& problem, std::size_t candidate, long draw) {
  RandomStream random(problem.seed, stream_index(0, candidate, draw), DrawPurpose::of_prior);
  Point unit{};
  for (double& place : unit) place = random.uniform();
  return unit;
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
  // In turns, so that an interrupted set is one of all candidates.
  for (bool any = true; any && !stopped(options);) {
    any = false;
    for (std::size_t c = 0; c < candidates; ++c) {
      if (!unfinished(c) || stopped(options)) continue;
      const long before = drawn[c];
      simulate_draws(
          problem, c, draws_together, [&](long k) { return prior_point(problem, c, before + k); }, options,
          cases[c]);
      drawn[c] += draws_together;
      any = true;
      if (!options.on_cases) continue;
      std::size_t done = 0;
      for (std::size_t k = 0; k < candidates; ++k) done += unfinished(k) ? cases[k].size() : wanted;
      options.on_cases(done, wanted * candidates);
    }
  }
  CaseSet set;
  for (std::size_t c = 0; c < candidates; ++c) {
    set.draws.push_back({c, drawn[c], std::nullopt});
    std::ranges::move(cases[c], std::back_inserter(set.cases));
  }
  return set;
}

void add_proposed_cases(const DiagnosisProblem& problem, std::size_t candidate, const Proposal& proposal,
                        int count, int round, const CaseOptions& options, CaseSet& set) {
  const std::size_t before = set.cases.size();
  simulate_draws(
      problem, candidate, count,
      [&](long k) {
        RandomStream random(problem.seed, stream_index(round, candidate, k), DrawPurpose::of_proposal);
        return proposal.draw(random);
      },
      options, set.cases);
  for (std::size_t i = before; i < set.cases.size(); ++i) set.cases[i].proposed = true;
  set.draws.push_back({candidate, count, proposal});
}

Eigen::VectorXd importance_weights(const DiagnosisProblem& problem, const CaseSet& set) {
  Eigen::VectorXd weight(static_cast<Eigen::Index>(set.cases.size()));
  std::vector<double> all(problem.candidates.size(), 0.0);
  for (Eigen::Index i = 0; i < weight.size(); ++i) {
    const SimulatedCase& one = set.cases[static_cast<std::size_t>(i)];
    double mixture = 0, drawn = 0;
    for (const Draws& draws : set.draws) {
      if (draws.candidate != one.candidate) continue;
      drawn += static_cast<double>(draws.count);
      mixture += static_cast<double>(draws.count) * (draws.proposal ? draws.proposal->density(one.unit) : 1);
    }
    weight(i) = drawn / mixture;
    all[one.candidate] += weight(i);
  }
  for (Eigen::Index i = 0; i < weight.size(); ++i) {
    const std::size_t c = set.cases[static_cast<std::size_t>(i)].candidate;
    weight(i) *= problem.prior[c] / all[c];
  }
  return weight;
}

}  // namespace rubsweep::diagnose::inference
