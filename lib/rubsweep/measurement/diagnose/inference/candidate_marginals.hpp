#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/marginal.hpp"
#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

namespace rubsweep::diagnose::inference {

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
