#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/proposal.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

namespace rubsweep::diagnose::inference {

/// How many motions are simulated.
struct CaseOptions {
  int cases_per_candidate = 600;    ///< that rub, drawn from the priors
  int most_draws_per_case = 30;     ///< on average; what rubs more rarely stays with fewer cases
  int threads = 0;                  ///< 0: one for every processor; decides no result
  const std::atomic<bool>* stop{};  ///< true: no new draw begins
  std::function<void(std::size_t done, std::size_t all)> on_cases{};  ///< of the priors; one call at a time
};

/// Cases that were kept of draws from one density.
struct Draws {
  std::size_t candidate = 0;
  long count = 0;                      ///< draws, with those that do not rub
  std::optional<Proposal> proposal{};  ///< empty: the prior
};

/// Simulated cases of all candidates, and where they were drawn from.
struct CaseSet {
  std::vector<SimulatedCase> cases{};
  std::vector<Draws> draws{};
};

/// Draws from the priors until every candidate has its cases, or its draws are used up. Depends on the
/// problem and on cases_per_candidate alone.
CaseSet prior_cases(const DiagnosisProblem& problem, const CaseOptions& options);

/// Adds the rubbing ones of `count` draws from a proposal. `round`: from 1 on, to draw other numbers in each.
void add_proposed_cases(const DiagnosisProblem& problem, std::size_t candidate, const Proposal& proposal,
                        int count, int round, const CaseOptions& options, CaseSet& set);

/// Weight of every case: density of the prior over that of all draws of its candidate (deterministic mixture;
/// Owen, Zhou 2000), scaled so that those of each candidate add up to its prior probability. A candidate
/// without cases has none.
Eigen::VectorXd importance_weights(const DiagnosisProblem& problem, const CaseSet& set);

}  // namespace rubsweep::diagnose::inference
