#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Smallest kernel width in the unit cube: draws from a narrower kernel would almost repeat its case.
constexpr double least_deviation = 0.02;

constexpr double negligible = 1e-6;  ///< Share of the prior's density that a kernel may leave out.

/// Reflects a number at 0 and 1 until it lies in [0, 1].
double folded(double x) {
  const double twice = x - 2 * std::floor(x / 2);
  return twice > 1 ? 2 - twice : twice;
}

double gaussian(double x, double deviation) {
  return std::exp(-x * x / (2 * deviation * deviation)) / (deviation * std::sqrt(2 * std::numbers::pi));
}

/// Density of the folded kernel. Both ends reflect it like mirrors; only the nearest images matter.
double folded_density(double x, double centre, double deviation) {
  double sum = 0;
  for (const double image : {centre, -centre, 2 - centre, centre - 2, centre + 2})
    sum += gaussian(x - image, deviation);
  return sum;
}

/// Draws simulated as one batch. Drawing ends only after a whole batch, so the number of threads does not
/// change the result.
constexpr int draws_together = 128;

/// Simulates draws and keeps the successful ones as cases, in the order of the draws.
template <class PointOf>
void simulate_draws(const DiagnosisProblem& problem, std::size_t candidate, int count,
                    const PointOf& point_of, const CaseOptions& options, std::vector<SimulatedCase>& cases) {
  std::vector<std::optional<SimulatedCase>> simulated(static_cast<std::size_t>(count));
  const std::atomic<bool> go_on{false};
  batch::parallel_run(
      simulated.size(), options.threads,
      [&](std::size_t k) {
        thread_local response::spectrum::SpectrumWorkspace workspace;
        simulated[k] = simulate_case(problem, candidate, point_of(static_cast<long>(k)), workspace);
      },
      {}, options.stop ? *options.stop : go_on);
  for (auto& one : simulated)
    if (one) cases.push_back(*std::move(one));
}

/// Index of the random stream of draw number `draw` of a candidate in a round.
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

Proposal::Proposal(const Candidate& candidate, std::vector<Point> centres, std::vector<double> weight)
    : centres_(std::move(centres)), weight_(std::move(weight)) {
  const double all = std::accumulate(weight_.begin(), weight_.end(), 0.0);
  for (double& w : weight_) w /= all;
  for (std::size_t j = 0; j < unknown_count; ++j) {
    if (candidate.spreads[j].low == candidate.spreads[j].high) continue;
    unknown_.push_back(j);
    double mean = 0, square = 0;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      mean += weight_[i] * centres_[i][j];
      square += weight_[i] * centres_[i][j] * centres_[i][j];
    }
    constexpr double most_deviation = 0.3;
    deviation_[j] =
        std::clamp(std::sqrt(2 * std::max(0.0, square - mean * mean)), least_deviation, most_deviation);
  }
}

Point Proposal::draw(RandomStream& random) const {
  double left = random.uniform();
  std::size_t chosen = 0;
  while (chosen + 1 < centres_.size() && left >= weight_[chosen]) left -= weight_[chosen++];
  Point unit = centres_[chosen];
  for (const std::size_t j : unknown_) unit[j] = folded(unit[j] + deviation_[j] * random.normal());
  return unit;
}

double Proposal::density(const Point& unit) const {
  double sum = 0;
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    if (weight_[i] == 0) continue;
    double product = weight_[i];
    for (const std::size_t j : unknown_) {
      product *= folded_density(unit[j], centres_[i][j], deviation_[j]);
      if (product < negligible) break;
    }
    sum += product;
  }
  return sum;
}

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
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    weight(i) /= all[set.cases[static_cast<std::size_t>(i)].candidate];
  return weight;
}

}  // namespace rubsweep::diagnose::inference
