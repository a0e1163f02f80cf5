#include "rubsweep/diagnose/inference/posterior.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/diagnose/forest/forest.hpp"
#include "rubsweep/diagnose/forest/novelty.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Share of each candidate that a forest of so many cases cannot tell from none.
constexpr double least_probability = 1e-3;

/// Probabilities to a power.
Eigen::RowVectorXd sharpened(const Eigen::RowVectorXd& probability, double power) {
  const Eigen::RowVectorXd raised = (probability.array() + least_probability).pow(power);
  return raised / raised.sum();
}

/// Power that makes the true candidates of cases that a tree did not draw most likely (temperature scaling;
/// Guo et al. 2017).
double best_sharpness(const Eigen::MatrixXd& out_of_bag, const std::vector<int>& label,
                      const Eigen::VectorXd& weight) {
  const auto loss = [&](double power) {
    double sum = 0;
    for (Eigen::Index i = 0; i < out_of_bag.rows(); ++i)
      if (out_of_bag.row(i).sum() > 0)
        sum -= weight(i) * std::log(sharpened(out_of_bag.row(i), power)(label[static_cast<std::size_t>(i)]));
    return sum;
  };
  // Golden section of a convex function.
  constexpr double golden = 0.6180339887498949;
  double low = 0.2, high = 5;
  for (int k = 0; k < 30; ++k) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (loss(a) < loss(b) ? high : low) = loss(a) < loss(b) ? b : a;
  }
  return (low + high) / 2;
}

/// Rows that were drawn from the priors.
Eigen::MatrixXd rows_of_priors(const CaseSet& set, const Eigen::MatrixXd& features) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < set.cases.size(); ++i)
    if (!set.cases[i].proposed) rows.push_back(static_cast<Eigen::Index>(i));
  return features(rows, Eigen::all);
}

}  // namespace

void observe_cases(const DiagnosisProblem& problem, const CaseSet& set, int threads,
                   ObservedCases& observed) {
  const auto before = static_cast<std::size_t>(observed.features.rows());
  const std::size_t added = set.cases.size() - before;
  if (added == 0) return;
  std::vector<ObservedCase> seen(added);
  batch::parallel_run(
      added, threads,
      [&](std::size_t k) {
        thread_local response::spectrum::SpectrumWorkspace workspace;
        seen[k] = observe(problem, set.cases[before + k], before + k, workspace);
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  const auto all = static_cast<Eigen::Index>(set.cases.size());
  observed.features.conservativeResize(all, static_cast<Eigen::Index>(seen.front().seen.features.size()));
  for (auto* column : {&observed.size_m, &observed.direction_rad, &observed.probe_angle_rad})
    column->conservativeResize(all);
  for (std::size_t k = 0; k < added; ++k) {
    const auto row = static_cast<Eigen::Index>(before + k);
    observed.features.row(row) = features::values_of(seen[k].seen.features).transpose();
    observed.size_m(row) = seen[k].seen.size_m;
    observed.direction_rad(row) = seen[k].seen.direction_rad;
    observed.probe_angle_rad(row) = seen[k].probe_angle_rad;
  }
}

double clearance_m(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                   double seen_size_m) {
  return simulated_clearance_m(problem.candidates[one.candidate]) * seen_size_m / case_size_m;
}

Posterior posterior_of(const DiagnosisProblem& problem, const CaseSet& set, const ObservedCases& observed,
                       const features::DescribedMotion& seen, int threads) {
  forest::LabelledSamples samples{
      observed.features, {}, importance_weights(problem, set), static_cast<int>(problem.candidates.size())};
  for (const SimulatedCase& one : set.cases) samples.label.push_back(static_cast<int>(one.candidate));
  const forest::Forest forest(samples, {.seed = problem.seed, .threads = threads});
  Posterior posterior;
  const Eigen::VectorXd here = features::values_of(seen.features);
  posterior.weight = forest.posterior_weights(here);
  for (Eigen::Index i = 0; i < posterior.weight.size(); ++i) {
    const SimulatedCase& one = set.cases[static_cast<std::size_t>(i)];
    const Candidate& candidate = problem.candidates[one.candidate];
    if (candidate.cause == Cause::no_rub) continue;
    // Clearances are drawn evenly in their logarithm: those that the size asks for count alike, others not at
    // all.
    const double clearance = clearance_m(problem, one, observed.size_m(i), seen.size_m);
    if (clearance < candidate.clearance_m.low || clearance > candidate.clearance_m.high)
      posterior.weight(i) = 0;
  }
  Eigen::RowVectorXd share = Eigen::RowVectorXd::Zero(samples.classes);
  for (Eigen::Index i = 0; i < posterior.weight.size(); ++i)
    share(samples.label[static_cast<std::size_t>(i)]) += posterior.weight(i);
  posterior.sharpness = best_sharpness(forest.out_of_bag_probabilities(), samples.label, samples.weight);
  const Eigen::RowVectorXd relative = share.sum() > 0 ? Eigen::RowVectorXd(share / share.sum()) : share;
  posterior.probability = sharpened(relative, posterior.sharpness).transpose();
  for (Eigen::Index i = 0; i < posterior.weight.size(); ++i) {
    const int label = samples.label[static_cast<std::size_t>(i)];
    if (share(label) > 0) posterior.weight(i) *= posterior.probability(label) / share(label);
  }
  posterior.p_value = forest::Novelty(rows_of_priors(set, observed.features), threads).p_value(here);
  posterior.none = forest::probability_of_none(posterior.p_value);
  return posterior;
}

}  // namespace rubsweep::diagnose::inference
