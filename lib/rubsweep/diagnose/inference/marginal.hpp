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

/// Marginal posterior distribution of a quantity, of few weighted cases. Among n equal cases the true value
/// has n + 1 places, each as likely: the i-th smallest case is the i / (n + 1) quantile (Weibull's plotting
/// positions), and 1 / (n + 1) lies beyond each end. Weighted cases count as effective_cases. Between two of
/// them, and beyond the ends, the distribution has the shape of the prior.
class Marginal {
 public:
  /// `weight`: of every case in the posterior, > 0 for one at least. `prior`: of every case in the prior,
  /// > 0 wherever `weight` is. `angle`: values are degrees, and compared on the circle, cut opposite to their
  /// mean direction.
  Marginal(const Eigen::VectorXd& values, const Eigen::VectorXd& weight, const Eigen::VectorXd& prior,
           bool angle);

  /// Probability of less than `value`, and half of that of the cases that equal it.
  double share_below(double value) const;

  /// Value below which the quantity lies with this probability.
  double quantile(double share) const;

 private:
  bool angle_;
  double middle_deg_ = 0;                  ///< mean direction
  std::vector<double> value_{}, share_{};  ///< of the prior's cases, and the probability of less; both rise
};

/// Marginal posterior of a quantity, given that the cause is this candidate. Cases of it must weigh
/// something.
Marginal marginal_of(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                     const features::DescribedMotion& seen, std::size_t candidate, Quantity quantity);

}  // namespace rubsweep::diagnose::inference
