#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

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

}  // namespace

Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads, double evidence_power) {
  Eigen::MatrixXd by_half(static_cast<Eigen::Index>(halves),
                          static_cast<Eigen::Index>(problem.candidates.size()) + 1);
  for (std::uint64_t k = 0; k < halves; ++k) {
    RandomStream random(problem.seed, k, DrawPurpose::of_half);
    const std::vector<Eigen::Index> rows = half_of_cases(problem, set, random);
    std::vector<Eigen::Index> others(static_cast<std::size_t>(observed.of_other_causes.rows()));
    for (std::size_t i = 0; i < others.size(); ++i) others[i] = static_cast<Eigen::Index>(i);
    others = half_of(std::move(others), random);
    CaseSet half;
    for (const Eigen::Index i : rows) half.cases.push_back(set.cases[static_cast<std::size_t>(i)]);
    const ObservedCases seen_half{observed.features(rows, Eigen::all), observed.size_m(rows),
                                  observed.direction_rad(rows), observed.probe_angle_rad(rows),
                                  observed.of_other_causes(others, Eigen::all)};
    by_half.row(static_cast<Eigen::Index>(k)) =
        log_odds(posterior_of(problem, half, seen_half, seen, threads, evidence_power)).transpose();
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
  diagnosis.observed = observed_cases(problem, diagnosis.set, threads);
  diagnosis.p_value = p_value_of(diagnosis.observed, seen, threads);
  const double power = evidence_power_of(diagnosis.p_value);
  diagnosis.posterior = posterior_of(problem, diagnosis.set, diagnosis.observed, seen, threads, power);
  for (std::size_t c = 0; c < problem.candidates.size(); ++c)
    diagnosis.marginals.push_back(
        marginals_of(problem, diagnosis.set, diagnosis.observed, diagnosis.posterior, seen, c, threads));
  diagnosis.posterior.forest.reset();
  if (options.with_standard_error)
    diagnosis.standard_error = sampling_errors(problem, diagnosis.set, diagnosis.observed, seen,
                                               diagnosis.posterior, threads, power);
  return diagnosis;
}

Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate) {
  Eigen::VectorXd weight = diagnosis.posterior.weight;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (diagnosis.set.cases[static_cast<std::size_t>(i)].candidate != candidate) weight(i) = 0;
  return weight;
}

}  // namespace rubsweep::diagnose::inference
