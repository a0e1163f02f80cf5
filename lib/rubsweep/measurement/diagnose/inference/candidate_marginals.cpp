#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::inference {
namespace {

using std::numbers::pi;

double mean_direction_deg(const Eigen::VectorXd& values, const Eigen::VectorXd& weight) {
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) sum += weight(i) * std::polar(1.0, values(i) * pi / 180);
  return std::arg(sum) * 180 / pi;
}

/// Share of the posterior and share of the prior that all cases with one value have together.
struct ValueShare {
  double value = 0, posterior = 0, prior = 0;
};

/// Shares sorted by ascending value; cases of equal value are merged.
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

/// Point of the map from the cumulative probability of the prior to that of the posterior.
struct Knot {
  double prior = 0, posterior = 0;
};

/// Replaces the cases by `count` cases of equal weight, at even steps of the posterior (their plotting
/// positions). Cases with the same value are spread evenly over the prior share of this value.
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

/// Values of one quantity in the cases of a candidate.
struct QuantityCases {
  Quantity quantity;
  Eigen::VectorXd values{};

  Marginal marginal(const Eigen::VectorXd& weight, const Eigen::VectorXd& prior) const {
    return {values, weight, prior, quantity == Quantity::stop_angle};
  }
};

/// Rank of a value among others, from 0 to 1. Equal values, such as the time share of a contact that never
/// ends, cover an interval of ranks; `fraction` selects a point of this interval.
double rank_in(const Marginal& marginal, double value, double fraction) {
  const double below = marginal.probability_below(value);
  return below + fraction * (marginal.probability_up_to(value) - below);
}

/// Indices of the cases with the largest weights; cases without weight are left out.
std::vector<std::size_t> heaviest(const Eigen::VectorXd& weight, std::size_t most) {
  std::vector<std::size_t> cases;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (weight(i) > 0) cases.push_back(static_cast<std::size_t>(i));
  std::ranges::stable_sort(cases, std::greater{},
                           [&](std::size_t i) { return weight(static_cast<Eigen::Index>(i)); });
  cases.resize(std::min(cases.size(), most));
  return cases;
}

/// Ranks of the quantities, one row per case of the candidate. NaN where a case is not ranked, or where every
/// tree drew it.
Eigen::MatrixXd out_of_bag_ranks(const std::vector<QuantityCases>& quantities,
                                 const std::vector<Eigen::Index>& rows, const Posterior& posterior,
                                 const Eigen::VectorXd& prior, int threads) {
  constexpr std::size_t most_ranked = 1000;
  const std::vector<std::size_t> ranked = heaviest(posterior.weight(rows), most_ranked);
  Eigen::MatrixXd ranks = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows.size()),
                                                    static_cast<Eigen::Index>(quantities.size()),
                                                    std::numeric_limits<double>::quiet_NaN());
  batch::parallel_run(ranked.size(), threads, [&](std::size_t place) {
    const std::size_t k = ranked[place];
    const Eigen::VectorXd all = posterior.forest->out_of_bag_weights(static_cast<int>(rows[k]));
    if (all.size() == 0) return;
    const auto row = static_cast<Eigen::Index>(k);
    const Eigen::VectorXd weight = all(rows).cwiseProduct(posterior.size_density(rows));
    if (weight.sum() == 0) return;
    constexpr double golden = 0.6180339887498949;
    const double fraction = golden * static_cast<double>(k) - std::floor(golden * static_cast<double>(k));
    for (std::size_t q = 0; q < quantities.size(); ++q)
      ranks(row, static_cast<Eigen::Index>(q)) =
          rank_in(quantities[q].marginal(weight, prior), quantities[q].values(row), fraction);
  });
  return ranks;
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

double beta_of_ranks(const Eigen::VectorXd& ranks, const Eigen::VectorXd& weight) {
  constexpr double nearest_to_end = 1e-4, deviation = 0.25, most = 1.5;
  const double count = effective_cases(weight);
  if (count == 0) return 1;
  const Eigen::ArrayXd inside = ranks.array().max(nearest_to_end).min(1 - nearest_to_end);
  const double mean_log = (weight.array() * (inside * (1 - inside)).log()).sum() / weight.sum();
  const auto loss = [&](double log_beta) {
    const double beta = std::exp(log_beta);
    const double log_of_beta_function = 2 * boost::math::lgamma(beta) - boost::math::lgamma(2 * beta);
    return count * (log_of_beta_function - (beta - 1) * mean_log) +
           log_beta * log_beta / (2 * deviation * deviation);
  };
  constexpr int bits = 20;
  return std::exp(boost::math::tools::brent_find_minima(loss, -most, most, bits).first);
}

std::vector<QuantityMarginal> marginals_of(const DiagnosisProblem& problem, const CaseSet& set,
                                           const ObservedCases& observed, const Posterior& posterior,
                                           const features::DescribedMotion& seen, std::size_t candidate,
                                           int threads) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < set.cases.size(); ++i)
    if (set.cases[i].candidate == candidate) rows.push_back(static_cast<Eigen::Index>(i));
  const Eigen::VectorXd weight = posterior.weight(rows);
  if (weight.sum() == 0) return {};
  const Eigen::VectorXd prior = posterior.size_density(rows);
  std::vector<QuantityCases> quantities;
  for (const Quantity quantity : all_quantities)
    if (has_quantity(problem, candidate, quantity))
      quantities.push_back({quantity, values_in_cases(problem, set, observed, seen, quantity)(rows)});
  if (quantities.empty()) return {};
  const Eigen::MatrixXd ranks = out_of_bag_ranks(quantities, rows, posterior, prior, threads);
  std::vector<QuantityMarginal> marginals;
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const auto rank = ranks.col(static_cast<Eigen::Index>(q)).array();
    const double beta = beta_of_ranks(rank.isNaN().select(0.5, rank), rank.isNaN().select(0, weight.array()));
    marginals.push_back(
        {quantities[q].quantity, quantities[q].marginal(weight, prior).beta_transformed(beta)});
  }
  return marginals;
}

}  // namespace rubsweep::diagnose::inference
