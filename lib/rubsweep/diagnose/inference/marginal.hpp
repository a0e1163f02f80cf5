#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/diagnose/inference/diagnosis.hpp"
#include "rubsweep/diagnose/inference/quantity.hpp"

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

  /// Probability of less than `value`, and half of that of `value` itself.
  double share_below(double value) const;

  /// Value of the case at which the probability of this value or less reaches `share`, from 0 to 1.
  double quantile(double share) const;

 private:
  bool angle_;
  double middle_deg_ = 0;        ///< mean direction
  std::vector<double> value_{};  ///< rising
  std::vector<double> up_to_{};  ///< probability of each value or less; the last is 1
};

/// Marginal posterior of a quantity, given that the cause is this candidate. Cases of it must weigh
/// something.
Marginal marginal_of(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                     const features::DescribedMotion& seen, std::size_t candidate, Quantity quantity);

}  // namespace rubsweep::diagnose::inference
