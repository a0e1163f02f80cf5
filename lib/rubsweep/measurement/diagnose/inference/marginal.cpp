#include "rubsweep/measurement/diagnose/inference/marginal.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

namespace rubsweep::diagnose::inference {
namespace {

using std::numbers::pi;

double mean_direction_deg(const Eigen::VectorXd& values, const Eigen::VectorXd& weight) {
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) sum += weight(i) * std::polar(1.0, values(i) * pi / 180);
  return std::arg(sum) * 180 / pi;
}

/// All cases of one value, and their shares of the posterior and of the prior.
struct ValueShare {
  double value = 0, posterior = 0, prior = 0;
};

/// In rising order, those that are equal together.
std::vector<ValueShare> sorted_shares(std::vector<ValueShare> cases) {
  std::ranges::stable_sort(cases, {}, &ValueShare::value);
  std::vector<ValueShare> merged;
  for (const ValueShare& one : cases) {
    if (merged.empty() || merged.back().value != one.value) merged.push_back({one.value, 0, 0});
    merged.back().posterior += one.posterior;
    merged.back().prior += one.prior;
  }
  return merged;
}

/// Point of the map from the probability of less in the prior to that in the posterior.
struct Knot {
  double prior = 0, posterior = 0;
};

/// `count` equal cases at even steps of the posterior, at their plotting positions; those of one value are
/// spread evenly over its share of the prior.
std::vector<Knot> knots_of(const std::vector<ValueShare>& shares, int count) {
  std::vector<Knot> knots{{0, 0}};
  double prior = 0, posterior = 0;
  int before = 0;
  for (const ValueShare& one : shares) {
    posterior += one.posterior;
    const int up_to = one.value == shares.back().value
                          ? count
                          : std::clamp(static_cast<int>(std::floor(posterior * count + 0.5)), before, count);
    for (int k = before; k < up_to; ++k)
      knots.push_back({prior + one.prior * (k - before + 0.5) / (up_to - before), (k + 1.0) / (count + 1)});
    before = up_to;
    prior += one.prior;
  }
  knots.push_back({1, 1});
  return knots;
}

}  // namespace

double effective_cases(const Eigen::VectorXd& weight) {
  const double sum = weight.sum();
  return sum > 0 ? 1 / (weight / sum).squaredNorm() : 0;
}

Marginal::Marginal(const Eigen::VectorXd& values, const Eigen::VectorXd& weight, const Eigen::VectorXd& prior,
                   bool angle)
    : angle_(angle) {
  if (angle) middle_deg_ = mean_direction_deg(values, weight);
  std::vector<ValueShare> cases;
  const double all = weight.sum(), all_of_prior = prior.sum();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (const double share = prior(i) / all_of_prior; share > 0)
      cases.push_back({from_middle(values(i)), weight(i) / all, share});
  const std::vector<ValueShare> shares = sorted_shares(std::move(cases));
  const std::vector<Knot> knots =
      knots_of(shares, std::max(1, static_cast<int>(std::lround(effective_cases(weight)))));
  double below = 0;
  auto next = knots.begin() + 1;
  for (const ValueShare& one : shares) {
    below = std::min(1.0, below + one.prior);
    while (next + 1 != knots.end() && next->prior < below) ++next;
    const Knot& last = *(next - 1);
    value_.push_back(one.value);
    up_to_.push_back(last.posterior +
                     (next->posterior - last.posterior) * (below - last.prior) / (next->prior - last.prior));
  }
  up_to_.back() = 1;
}

double Marginal::probability_below(double value) const {
  return before(std::ranges::lower_bound(value_, from_middle(value)) - value_.begin());
}

double Marginal::probability_up_to(double value) const {
  return before(std::ranges::upper_bound(value_, from_middle(value)) - value_.begin());
}

double Marginal::quantile(double share) const {
  const auto reached = std::ranges::lower_bound(up_to_, share) - up_to_.begin();
  const double x = value_[std::min(static_cast<std::size_t>(reached), value_.size() - 1)];
  return angle_ ? wrapped_deg(x + middle_deg_) : x;
}

Marginal Marginal::beta_transformed(double beta) const {
  Marginal transformed = *this;
  for (double& probability : transformed.up_to_) probability = boost::math::ibeta(beta, beta, probability);
  return transformed;
}

double Marginal::from_middle(double value) const { return angle_ ? wrapped_deg(value - middle_deg_) : value; }

double Marginal::before(std::ptrdiff_t k) const {
  return k == 0 ? 0 : up_to_[static_cast<std::size_t>(k - 1)];
}

}  // namespace rubsweep::diagnose::inference
