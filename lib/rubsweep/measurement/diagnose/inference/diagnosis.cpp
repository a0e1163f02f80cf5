#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {
namespace {

constexpr std::uint64_t halves = 8;

/// A random half of these numbers, rounded up.
std::vector<Eigen::Index> half_of(std::vector<Eigen::Index> numbers, RandomStream& random) {
  const std::size_t wanted = (numbers.size() + 1) / 2;
  for (std::size_t k = 0; k < wanted; ++k) {
    const auto left = static_cast<double>(numbers.size() - k);
    std::swap(numbers[k], numbers[k + static_cast<std::size_t>(left * random.uniform())]);
  }
  numbers.resize(wanted);
  return numbers;
}

/// Rows of a random half of each candidate's cases.
std::vector<Eigen::Index> half_of_cases(const DiagnosisProblem& problem, const CaseSet& set,
                                        RandomStream& random) {
  std::vector<std::vector<Eigen::Index>> rows(problem.candidates.size());
  for (std::size_t i = 0; i < set.cases.size(); ++i)
    rows[set.cases[i].candidate].push_back(static_cast<Eigen::Index>(i));
  std::vector<Eigen::Index> half;
  for (std::vector<Eigen::Index>& of_candidate : rows) {
    const auto chosen = half_of(std::move(of_candidate), random);
    half.insert(half.end(), chosen.begin(), chosen.end());
  }
  return half;
}

Eigen::VectorXd probabilities_of(const Posterior& posterior) {
  Eigen::VectorXd all(posterior.probability.size() + 1);
  all << (1 - posterior.none) * posterior.probability, posterior.none;
  return all;
}

Eigen::ArrayXd log_odds(const Posterior& posterior) {
  const Eigen::ArrayXd p = probabilities_of(posterior);
  return (p / (1 - p)).log();
}

bool stopped(const DiagnosisOptions& options) { return options.cases.stop && *options.cases.stop; }

/// Proposal around the cases of a candidate with the largest weights; empty where all its weights are zero.
std::optional<Proposal> proposal_of(const DiagnosisProblem& problem, std::size_t candidate,
                                    const CaseSet& set, const Eigen::VectorXd& weight) {
  constexpr std::size_t most_centres = 60;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < set.cases.size(); ++i)
    if (set.cases[i].candidate == candidate && weight(static_cast<Eigen::Index>(i)) > 0) rows.push_back(i);
  if (rows.empty()) return std::nullopt;
  std::ranges::stable_sort(rows, std::greater{},
                           [&](std::size_t i) { return weight(static_cast<Eigen::Index>(i)); });
  rows.resize(std::min(rows.size(), most_centres));
  std::vector<Point> centres;
  std::vector<double> shares;
  for (const std::size_t i : rows) {
    centres.push_back(set.cases[i].unit);
    shares.push_back(weight(static_cast<Eigen::Index>(i)));
  }
  return Proposal(problem.candidates[candidate], std::move(centres), std::move(shares));
}

/// Number of draws of a candidate in a round: most for likely candidates, a few for every candidate that is
/// still possible.
int draws_of(double probability, int all) {
  constexpr double possible = 0.01;
  if (probability < possible) return 0;
  return static_cast<int>(std::lround(all * std::sqrt(probability) / 2));
}

void narrow(const DiagnosisProblem& problem, const DiagnosisOptions& options, int round,
            Diagnosis& diagnosis) {
  const Posterior& posterior = diagnosis.posterior;
  const Eigen::VectorXd weight = posterior.weight;
  for (std::size_t c = 0; c < problem.candidates.size(); ++c) {
    if (problem.candidates[c].cause == Cause::no_rub || stopped(options)) continue;
    const int draws = draws_of(posterior.probability(static_cast<Eigen::Index>(c)), options.draws_per_round);
    if (draws == 0) continue;
    const auto proposal = proposal_of(problem, c, diagnosis.set, weight);
    if (proposal) add_proposed_cases(problem, c, *proposal, draws, round, options.cases, diagnosis.set);
  }
}

}  // namespace

Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads) {
  Eigen::MatrixXd by_half(static_cast<Eigen::Index>(halves),
                          static_cast<Eigen::Index>(problem.candidates.size()) + 1);
  for (std::uint64_t k = 0; k < halves; ++k) {
    RandomStream random(problem.seed, k, DrawPurpose::of_half);
    const std::vector<Eigen::Index> rows = half_of_cases(problem, set, random);
    std::vector<Eigen::Index> others(static_cast<std::size_t>(observed.of_other_causes.rows()));
    for (std::size_t i = 0; i < others.size(); ++i) others[i] = static_cast<Eigen::Index>(i);
    others = half_of(std::move(others), random);
    CaseSet half{.cases = {}, .draws = set.draws};
    for (const Eigen::Index i : rows) half.cases.push_back(set.cases[static_cast<std::size_t>(i)]);
    const ObservedCases seen_half{observed.features(rows, Eigen::all), observed.size_m(rows),
                                  observed.direction_rad(rows), observed.probe_angle_rad(rows),
                                  observed.of_other_causes(others, Eigen::all)};
    by_half.row(static_cast<Eigen::Index>(k)) =
        log_odds(posterior_of(problem, half, seen_half, seen, threads)).transpose();
  }
  const Eigen::MatrixXd off = by_half.rowwise() - by_half.colwise().mean();
  const Eigen::ArrayXd p = probabilities_of(posterior),
                       variance = off.colwise().squaredNorm().transpose() / (static_cast<double>(halves) - 1);
  return variance.sqrt() * p * (1 - p);
}

Diagnosis diagnose(const DiagnosisProblem& problem, const features::DescribedMotion& seen,
                   const DiagnosisOptions& options, std::optional<CaseSet> set) {
  Diagnosis diagnosis;
  diagnosis.set = set ? *std::move(set) : prior_cases(problem, options.cases);
  const int threads = options.cases.threads;
  for (int round = 0;; ++round) {
    observe_cases(problem, diagnosis.set, threads, diagnosis.observed);
    diagnosis.posterior.forest.reset();  // the two forests of many cases need much memory
    diagnosis.posterior = posterior_of(problem, diagnosis.set, diagnosis.observed, seen, threads);
    diagnosis.history.push_back(diagnosis.posterior.probability);
    if (round > 0) {
      const Eigen::VectorXd change =
          diagnosis.history.back() - diagnosis.history[diagnosis.history.size() - 2];
      diagnosis.stands_still = change.cwiseAbs().maxCoeff() < options.least_change;
    }
    if (round == options.most_rounds || diagnosis.stands_still || stopped(options)) break;
    narrow(problem, options, round + 1, diagnosis);
  }
  for (std::size_t c = 0; c < problem.candidates.size(); ++c)
    diagnosis.marginals.push_back(
        marginals_of(problem, diagnosis.set, diagnosis.observed, diagnosis.posterior, seen, c, threads));
  diagnosis.posterior.forest.reset();
  diagnosis.p_value = p_value_of(diagnosis.set, diagnosis.observed, seen, threads);
  if (!diagnosis.stands_still && options.with_standard_error)
    diagnosis.standard_error =
        sampling_errors(problem, diagnosis.set, diagnosis.observed, seen, diagnosis.posterior, threads);
  return diagnosis;
}

Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate) {
  Eigen::VectorXd weight = diagnosis.posterior.weight;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (diagnosis.set.cases[static_cast<std::size_t>(i)].candidate != candidate) weight(i) = 0;
  return weight;
}

}  // namespace rubsweep::diagnose::inference
