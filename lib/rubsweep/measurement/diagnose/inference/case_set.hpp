#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {

/// Density in the unit cube of a candidate's unknowns that is high near cases which resemble the recording:
/// Gaussian kernels whose variances are twice those of the cases (Beaumont, Cornuet, Marin, Robert 2009),
/// folded back at the faces of the cube. Known numbers stay as they are.
class Proposal {
 public:
  /// `weight` of each centre; not all zero.
  Proposal(const Candidate& candidate, std::vector<Point> centres, std::vector<double> weight);

  Point draw(RandomStream& random) const;

  /// Relative to that of the prior, which is 1 everywhere.
  double density(const Point& unit) const;

 private:
  std::vector<std::size_t> unknown_;  ///< numbers that are not known
  std::vector<Point> centres_;
  std::vector<double> weight_;  ///< add up to 1
  Point deviation_{};
};

/// How many motions are simulated.
struct CaseOptions {
  int cases_per_candidate = 600;    ///< number of rubbing cases, drawn from the priors
  int most_draws_per_case = 30;     ///< mean number of draws; what rubs more rarely stays with fewer cases
  int threads = 0;                  ///< 0: one for every processor; decides no result
  const std::atomic<bool>* stop{};  ///< true: no new draw begins
  std::function<void(std::size_t done, std::size_t all)> on_cases{};  ///< progress; one call at a time
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
