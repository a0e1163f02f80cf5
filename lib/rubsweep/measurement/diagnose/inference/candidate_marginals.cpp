#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"

#include <algorithm>
#include <atomic>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Cases of a candidate with one quantity.
struct QuantityCases {
  Quantity quantity;
  Eigen::VectorXd values{};

  Marginal marginal(const Eigen::VectorXd& weight, const Eigen::VectorXd& prior) const {
    return {values, weight, prior, quantity == Quantity::stop_angle};
  }
};

/// Rank of a value among others. Equal ones, as of a contact that never ends, share a stretch of ranks, and
/// `fraction` says where in it.
double rank_in(const Marginal& marginal, double value, double fraction) {
  const double below = marginal.probability_below(value);
  return below + fraction * (marginal.probability_up_to(value) - below);
}

/// The cases that weigh most, and anything.
std::vector<std::size_t> heaviest(const Eigen::VectorXd& weight, std::size_t most) {
  std::vector<std::size_t> cases;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (weight(i) > 0) cases.push_back(static_cast<std::size_t>(i));
  std::ranges::stable_sort(cases, std::greater{},
                           [&](std::size_t i) { return weight(static_cast<Eigen::Index>(i)); });
  cases.resize(std::min(cases.size(), most));
  return cases;
}

/// Ranks of the quantities, a row for each case of the candidate; NaN where it is not ranked, or no tree
/// tells.
Eigen::MatrixXd out_of_bag_ranks(const std::vector<QuantityCases>& quantities,
                                 const std::vector<Eigen::Index>& rows, const Posterior& posterior,
                                 const Eigen::VectorXd& prior, int threads) {
  constexpr std::size_t most_ranked = 1000;
  const std::vector<std::size_t> ranked = heaviest(posterior.weight(rows), most_ranked);
  Eigen::MatrixXd ranks = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows.size()),
                                                    static_cast<Eigen::Index>(quantities.size()),
                                                    std::numeric_limits<double>::quiet_NaN());
  batch::parallel_run(
      ranked.size(), threads,
      [&](std::size_t place) {
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
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  return ranks;
}

}  // namespace

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
  const Eigen::VectorXd prior = posterior.importance(rows).cwiseProduct(posterior.size_density(rows));
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
