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

/// Density over the unit cube of a candidate's unknowns, high near cases that resemble the recording. It is a
/// sum of Gaussian kernels whose variances are twice those of the cases (Beaumont, Cornuet, Marin, Robert
/// 2009), reflected at the faces of the cube. Known numbers keep their values.
class Proposal {
 public:
  /// `weight`: weights of the centres, not all zero.
  Proposal(const Candidate& candidate, std::vector<Point> centres, std::vector<double> weight);

  Point draw(RandomStream& random) const;

  double density(const Point& unit) const;  ///< Density relative to the prior, whose density is 1 everywhere.

 private:
  std::vector<std::size_t> unknown_;  ///< indices of the numbers that are not known
  std::vector<Point> centres_;
  std::vector<double> weight_;  ///< weights, which add up to 1
  Point deviation_{};
};

/// How many motions are simulated.
struct CaseOptions {
  int cases_per_candidate = 600;  ///< rubbing cases per candidate, drawn from the priors
  /// limit of the mean number of draws; candidates that rub too rarely get fewer cases
  int most_draws_per_case = 30;
  int threads = 0;                  ///< 0: one thread per processor; does not change the result
  const std::atomic<bool>* stop{};  ///< true: no new draw begins
  std::function<void(std::size_t done, std::size_t all)> on_cases{};  ///< progress; one call at a time
};

/// Draws from one density; their rubbing motions are kept as cases.
struct Draws {
  std::size_t candidate = 0;
  long count = 0;                      ///< number of draws, including those without a rub
  std::optional<Proposal> proposal{};  ///< density of the draws; empty: the prior
};

/// Simulated cases of all candidates, and the densities they were drawn from.
struct CaseSet {
  std::vector<SimulatedCase> cases{};
  std::vector<Draws> draws{};
};

/// Draws from the priors until every candidate has its cases or has used up its allowed draws. The result
/// depends on the problem, cases_per_candidate and most_draws_per_case alone.
CaseSet prior_cases(const DiagnosisProblem& problem, const CaseOptions& options);

/// Draws `count` times from a proposal and adds the rubbing cases. `round`: 1 or more; each round uses other
/// random numbers.
void add_proposed_cases(const DiagnosisProblem& problem, std::size_t candidate, const Proposal& proposal,
                        int count, int round, const CaseOptions& options, CaseSet& set);

/// Weight of every case: density of the prior divided by the mean density of all draws of its candidate
/// (deterministic mixture; Owen, Zhou 2000). The weights of each candidate add up to 1; a candidate without
/// cases has no weight.
Eigen::VectorXd importance_weights(const DiagnosisProblem& problem, const CaseSet& set);

}  // namespace rubsweep::diagnose::inference
