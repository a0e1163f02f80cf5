#pragma once

#include <Eigen/Core>
#include <memory>

#include "rubsweep/measurement/diagnose/forest/forest.hpp"
#include "rubsweep/measurement/diagnose/inference/case_set.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

namespace rubsweep::diagnose::inference {

/// Weight of a case by its size. It is the density of the logarithm of the case's size at the recording's
/// size, divided by a density that depends only on the candidate's clearances. The logarithms of clearances
/// are uniform, so all clearances that give the recording's size have equal weight, and others none. For a
/// quiet whirl, the whirl ratios take the place of the clearances. A known unbalance restricts the size of a
/// case as well.
double density_of_size(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                       double seen_size_m);

/// Probabilities after a recording was compared with the cases.
struct Posterior {
  Eigen::VectorXd probability{};  ///< probability of every candidate, provided that one of them is the cause
  Eigen::VectorXd weight{};  ///< weight of every case; the weights of a candidate add up to its probability
  Eigen::VectorXd size_density{};                  ///< density_of_size of every case
  std::shared_ptr<const forest::Forest> forest{};  ///< forest that gave the weights
  double none = 0;                                 ///< probability that none of the candidates is the cause
  double sharpness = 1;  ///< power that calibrates the probabilities (see best_sharpness)
};

/// Cases as the instrument measures them, one row of features per case.
struct ObservedCases {
  Eigen::MatrixXd features{};
  Eigen::VectorXd size_m{}, direction_rad{}, probe_angle_rad{};
  Eigen::MatrixXd of_other_causes{};  ///< features of vibrations of other causes, one row each
};

/// Observes all cases, and vibrations of other causes, three times as many as a candidate has cases.
ObservedCases observed_cases(const DiagnosisProblem& problem, const CaseSet& set, int threads);

/// Posterior from a forest in which vibrations of other causes form one more class. The forest compares
/// classes as if they were equally likely; its probabilities are then multiplied by the priors (Bayes'
/// theorem). `evidence_power`: further power of the likelihoods, > 0, see evidence_power_of; a candidate that
/// cannot have the recorded size is as unlikely as without it, and where "none of these" is likelier than all
/// candidates together, it does not count.
Posterior posterior_of(const DiagnosisProblem& problem, const CaseSet& set, const ObservedCases& observed,
                       const features::DescribedMotion& seen, int threads, double evidence_power = 1);

/// Share of the simulated cases whose apartness is at least that of the recording (forest::Novelty). This
/// check does not depend on the posterior.
double p_value_of(const ObservedCases& observed, const features::DescribedMotion& seen, int threads);

/// Power of the likelihoods of a recording with this p-value: from 1 at 0.2 or more to 1/2 at 0. A recording
/// that hardly any case resembles is weak evidence for each cause (coarsened posterior; Miller, Dunson 2019).
double evidence_power_of(double p_value);

}  // namespace rubsweep::diagnose::inference
