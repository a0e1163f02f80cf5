#include "rubsweep/diagnose/inference/marginal.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::diagnose::inference {
namespace {

using std::numbers::pi;

double mean_direction_deg(const Eigen::VectorXd& values, const Eigen::VectorXd& weight) {
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) sum += weight(i) * std::polar(1.0, values(i) * pi / 180);
  return std::arg(sum) * 180 / pi;
}

struct WeightedCase {
  double value = 0, weight = 0, prior = 0;
};

/// Between y0 at x0 and y1 at x1; the middle where x0 is x1.
double interpolated(double x, double x0, double y0, double x1, double y1) {
  return x1 > x0 ? y0 + (y1 - y0) * (x - x0) / (x1 - x0) : (y0 + y1) / 2;
}

/// Half of the weights of each case and all of those before it, of their sum.
std::vector<double> middles(const std::vector<WeightedCase>& cases, double WeightedCase::*weight) {
  std::vector<double> middle;
  double sum = 0;
  for (const WeightedCase& one : cases) {
    middle.push_back(sum + one.*weight / 2);
    sum += one.*weight;
  }
  for (double& place : middle) place /= sum;
  return middle;
}

/// Probability of less than each case. Those that weigh something are where their plotting positions say, the
/// others between them as the prior says.
std::vector<double> shares_below(const std::vector<WeightedCase>& cases, double count) {
  const std::vector<double> prior = middles(cases, &WeightedCase::prior),
                            posterior = middles(cases, &WeightedCase::weight);
  std::vector<double> share(cases.size());
  std::size_t first_open = 0;
  double prior_before = 0, share_before = 0;
  const auto fill = [&](std::size_t end, double prior_here, double share_here) {
    for (std::size_t k = first_open; k < end; ++k)
      share[k] = interpolated(prior[k], prior_before, share_before, prior_here, share_here);
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].weight <= 0) continue;
    share[i] = (count * posterior[i] + 0.5) / (count + 1);
    fill(i, prior[i], share[i]);
    first_open = i + 1;
    prior_before = prior[i];
    share_before = share[i];
  }
  fill(cases.size(), 1, 1);
  return share;
}

}  // namespace

double effective_cases(const Eigen::VectorXd& weight) {
  const double sum = weight.sum();
  return sum > 0 ? sum * sum / weight.squaredNorm() : 0;
}

Marginal::Marginal(const Eigen::VectorXd& values, const Eigen::VectorXd& weight, const Eigen::VectorXd& prior,
                   bool angle)
    : angle_(angle) {
  if (angle) middle_deg_ = mean_direction_deg(values, weight);
  std::vector<WeightedCase> cases;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (prior(i) > 0)
      cases.push_back({angle ? wrapped_deg(values(i) - middle_deg_) : values(i), weight(i), prior(i)});
  std::ranges::stable_sort(cases, {}, &WeightedCase::value);
  share_ = shares_below(cases, effective_cases(weight));
  for (const WeightedCase& one : cases) value_.push_back(one.value);
}

double Marginal::share_below(double value) const {
  const double x = angle_ ? wrapped_deg(value - middle_deg_) : value;
  const auto [first, last] = std::ranges::equal_range(value_, x);
  const auto below = first - value_.begin(), not_above = last - value_.begin();
  const auto share = [&](std::ptrdiff_t k) { return share_[static_cast<std::size_t>(k)]; };
  if (below < not_above) return (share(below) + share(not_above - 1)) / 2;
  if (first == value_.begin()) return 0;
  if (first == value_.end()) return 1;
  return interpolated(x, *(first - 1), share(below - 1), *first, share(below));
}

double Marginal::quantile(double share) const {
  const auto above = std::ranges::lower_bound(share_, share);
  const auto k = static_cast<std::size_t>(above - share_.begin());
  double x = value_[std::min(k, value_.size() - 1)];
  if (k > 0 && k < value_.size()) x = interpolated(share, share_[k - 1], value_[k - 1], share_[k], value_[k]);
  return angle_ ? wrapped_deg(x + middle_deg_) : x;
}

Marginal marginal_of(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                     const features::DescribedMotion& seen, std::size_t candidate, Quantity quantity) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < diagnosis.set.cases.size(); ++i)
    if (diagnosis.set.cases[i].candidate == candidate) rows.push_back(static_cast<Eigen::Index>(i));
  const Eigen::VectorXd values = values_in_cases(problem, diagnosis.set, diagnosis.observed, seen, quantity);
  return {values(rows), diagnosis.posterior.weight(rows), diagnosis.posterior.by_size(rows),
          quantity == Quantity::stop_angle};
}

}  // namespace rubsweep::diagnose::inference
