#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

namespace rubsweep::diagnose::inference {

/// Number of equal cases that say as much as cases of these weights: (sum w)^2 / sum w^2 (Kish 1965); 0
/// where none weighs anything.
double effective_cases(const Eigen::VectorXd& weight);

/// Marginal posterior distribution of a quantity, estimated from weighted cases. They are replaced by n equal
/// ones at even steps of their weights, n being effective_cases rounded. The true value has n + 1 places
/// among these, each as likely: the i-th smallest is the i / (n + 1) quantile (Weibull's plotting positions).
/// Between two of them, and beyond the outermost, the distribution has the shape of the prior.
class Marginal {
 public:
  /// `values`: finite. `weight`: of every case in the posterior, > 0 for one at least. `prior`: of every case
  /// in the prior, > 0 wherever `weight` is; no value without a case of it is possible. `angle`: values are
  /// degrees, and compared on the circle, cut opposite to their mean direction.
  Marginal(const Eigen::VectorXd& values, const Eigen::VectorXd& weight, const Eigen::VectorXd& prior,
           bool angle);

  double probability_below(double value) const;  ///< probability of less than `value`
  double probability_up_to(double value) const;  ///< probability of `value` or less

  /// Value of the case at which the probability of this value or less reaches `share`, from 0 to 1.
  double quantile(double share) const;

  /// Narrower about the median for `beta` > 1, wider for less: its probabilities are those that a beta
  /// distribution with both parameters `beta` has below them.
  Marginal beta_transformed(double beta) const;

 private:
  double from_middle(double value) const;  ///< difference of an angle from the middle; else the value itself
  double before(std::ptrdiff_t k) const;   ///< probability of the first k values

  bool angle_;
  double middle_deg_ = 0;        ///< mean direction
  std::vector<double> value_{};  ///< rising
  std::vector<double> up_to_{};  ///< probability of each value or less; the last is 1
};

struct QuantityMarginal {
  Quantity quantity;
  Marginal marginal;
};

/// Parameter of the symmetric beta distribution that weighted ranks from 0 to 1 come from most likely. Its
/// logarithm has a normal prior about 0 of standard deviation 0.25: few ranks hardly move it from 1.
double beta_of_ranks(const Eigen::VectorXd& ranks, const Eigen::VectorXd& weight);

/// Marginal posteriors of the quantities that a candidate has, given that it is the cause; none where no case
/// of it weighs anything. The posterior is the mean of those of many trees. A mean of distributions of which
/// each is right is too wide. It is narrowed by the beta transform (Gneiting, Ranjan 2013) that fits the
/// ranks of the similar cases, each among the cases that resemble it by the trees that did not draw it.
std::vector<QuantityMarginal> marginals_of(const DiagnosisProblem& problem, const CaseSet& set,
                                           const ObservedCases& observed, const Posterior& posterior,
                                           const features::DescribedMotion& seen, std::size_t candidate,
                                           int threads);

}  // namespace rubsweep::diagnose::inference
