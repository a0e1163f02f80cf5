#include "rubsweep/diagnose/inference/sampling_error.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rubsweep/diagnose/draw_purpose.hpp"

namespace rubsweep::diagnose::inference {
namespace {

constexpr std::uint64_t halves = 8;

/// Every second one of these numbers, drawn.
std::vector<Eigen::Index> half_of(std::vector<Eigen::Index> numbers, RandomStream& random) {
  const std::size_t wanted = (numbers.size() + 1) / 2;
  for (std::size_t k = 0; k < wanted; ++k) {
    const auto left = static_cast<double>(numbers.size() - k);
    std::swap(numbers[k], numbers[k + static_cast<std::size_t>(left * random.uniform())]);
  }
  numbers.resize(wanted);
  return numbers;
}

/// Rows of half of the cases of each candidate.
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

}  // namespace

Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                int threads) {
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
        probabilities_of(posterior_of(problem, half, seen_half, seen, threads)).transpose();
  }
  const Eigen::MatrixXd off = by_half.rowwise() - by_half.colwise().mean();
  return (off.colwise().squaredNorm() / (static_cast<double>(halves) - 1)).cwiseSqrt().transpose();
}

}  // namespace rubsweep::diagnose::inference
