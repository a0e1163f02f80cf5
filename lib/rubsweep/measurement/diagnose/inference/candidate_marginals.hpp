#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

namespace rubsweep::diagnose::inference {

/// Number of equally weighted cases that carry the same information: (sum w)^2 / sum w^2 (Kish 1965). It is 0
/// where all weights are zero.
double effective_cases(const Eigen::VectorXd& weight);

/// Marginal posterior distribution of a quantity, estimated from weighted cases. They are replaced by n cases
/// of equal weight at even steps of the posterior; n is effective_cases, rounded. The true value is equally
/// likely in each of the n + 1 gaps: the i-th smallest case is the i / (n + 1) quantile (Weibull's plotting
/// positions). Within each gap the distribution has the shape of the prior.
class Marginal {
 public:
  /// `values`: finite. `weight`: posterior weight of every case; at least one is > 0. `prior`: prior weight
  /// of every case, > 0 wherever `weight` is > 0. Values that occur in no case are impossible. `angle`:
  /// values are degrees; the circle is cut opposite to their mean direction.
  Marginal(const Eigen::VectorXd& values, const Eigen::VectorXd& weight, const Eigen::VectorXd& prior,
           bool angle);

  double probability_below(double value) const;  ///< probability of less than `value`
  double probability_up_to(double value) const;  ///< probability of `value` or less

  /// Value at which the cumulative probability reaches `share`, from 0 to 1.
  double quantile(double share) const;

  /// The distribution narrowed about the median for `beta` > 1, and widened for `beta` < 1. The new
  /// cumulative probability is that of a symmetric beta distribution with parameter `beta`, at the old
  /// cumulative probability.
  Marginal beta_transformed(double beta) const;

 private:
  /// for an angle, its difference from the middle; otherwise the value itself
  double from_middle(double value) const;
  double before(std::ptrdiff_t k) const;  ///< total probability of the first k values

  bool angle_;
  double middle_deg_ = 0;        ///< mean direction
  std::vector<double> value_{};  ///< values, ascending
  std::vector<double> up_to_{};  ///< cumulative probability of each value; the last is 1
};

struct QuantityMarginal {
  Quantity quantity;
  Marginal marginal;
};

/// Parameter of the symmetric beta distribution under which weighted ranks from 0 to 1 are most likely. Its
/// logarithm has a normal prior with mean 0 and standard deviation 0.25, so a few ranks hardly move it from
/// 1.
double beta_of_ranks(const Eigen::VectorXd& ranks, const Eigen::VectorXd& weight);

/// Marginal posteriors of the candidate's quantities, provided that the candidate is the cause; empty where
/// its cases have no weight. A posterior averaged over many trees is too wide, since a mean of correct
/// distributions is. A beta transform therefore narrows it (Gneiting, Ranjan 2013). The transform is fitted
/// to the ranks of similar cases, each computed from the trees that did not draw the case.
std::vector<QuantityMarginal> marginals_of(const DiagnosisProblem& problem, const CaseSet& set,
                                           const ObservedCases& observed, const Posterior& posterior,
                                           const features::DescribedMotion& seen, std::size_t candidate,
                                           int threads);

}  // namespace rubsweep::diagnose::inference
