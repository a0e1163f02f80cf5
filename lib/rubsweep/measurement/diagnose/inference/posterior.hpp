#pragma once

#include <Eigen/Core>
#include <memory>

#include "rubsweep/measurement/diagnose/forest/forest.hpp"
#include "rubsweep/measurement/diagnose/inference/case_set.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

namespace rubsweep::diagnose::inference {

/// Density of the logarithm of a case's size at that of the recording, over that of a size which goes by the
/// candidate's clearances alone. These are drawn evenly in their logarithm: those that the size asks for
/// count alike, others not at all. A quiet whirl counts by its whirl ratios. A known unbalance says the size
/// of a case as well.
double density_of_size(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                       double seen_size_m);

/// Probabilities after a recording.
struct Posterior {
  Eigen::VectorXd probability{};   ///< probability of every candidate, given that it is one of them
  Eigen::VectorXd weight{};        ///< weight of every case; those of a candidate add up to its probability
  Eigen::VectorXd importance{};    ///< weight of every case in proportion to importance_weights
  Eigen::VectorXd size_density{};  ///< density_of_size of every case
  std::shared_ptr<const forest::Forest> forest{};  ///< forest that gave the weights
  double none = 0;                                 ///< probability that it is none of them
  double sharpness = 1;  ///< power that makes the probabilities of cases not drawn by a tree fit best
};

/// Cases as the instrument shows them, one row of features each.
struct ObservedCases {
  Eigen::MatrixXd features{};
  Eigen::VectorXd size_m{}, direction_rad{}, probe_angle_rad{};
  Eigen::MatrixXd of_other_causes{};  ///< features of vibrations of other causes, a row each
};

/// Observes the cases that are not yet in `observed`, and at first as many vibrations of other causes as a
/// candidate has cases.
void observe_cases(const DiagnosisProblem& problem, const CaseSet& set, int threads, ObservedCases& observed);

/// Posterior by a forest in which vibrations of other causes are one more class.
Posterior posterior_of(const DiagnosisProblem& problem, const CaseSet& set, const ObservedCases& observed,
                       const features::DescribedMotion& seen, int threads);

/// Share of the simulated cases that are at least as far from all others as the recording is
/// (forest::Novelty): a check that does not use the posterior.
double p_value_of(const CaseSet& set, const ObservedCases& observed, const features::DescribedMotion& seen,
                  int threads);

}  // namespace rubsweep::diagnose::inference
