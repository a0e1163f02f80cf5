#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace rubsweep::diagnose::forest {

/// Test whether an observation belongs to the population of the simulated cases. Its apartness is its mean
/// distance to its nearest neighbours, divided by the mean distance of these neighbours to their own nearest
/// ones. This is a local outlier factor (Breunig, Kriegel, Ng, Sander 2000) without smoothing. The apartness
/// is compared with that of every case (conformal prediction; Vovk, Gammerman, Shafer 2005). Distances are
/// those of the features in units of their spread.
class Novelty {
 public:
  /// `cases`: one row per case, one column per feature.
  explicit Novelty(const Eigen::MatrixXd& cases, int threads = 0);

  /// Share of the cases whose apartness is at least that of the observation, in (0, 1]; uniformly distributed
  /// for observations of the population.
  double p_value(const Eigen::VectorXd& features) const;

 private:
  static constexpr std::size_t neighbours = 3;
  /// The nearest cases and their distances, ascending. Their number is `neighbours` + 1, because the case
  /// itself may be among them.
  using Nearest = std::array<std::pair<double, Eigen::Index>, neighbours + 1>;
  Nearest nearest(const Eigen::VectorXd& scaled, Eigen::Index without) const;
  /// `self`: index of the case itself, which is not its own neighbour; -1 for a new observation.
  double apartness(const Nearest& nearest, Eigen::Index self) const;
  Eigen::VectorXd scaled(const Eigen::VectorXd& features) const;

  Eigen::VectorXd middle_, spread_;
  Eigen::MatrixXd cases_;  ///< scaled features, one column per case
  std::vector<Nearest> of_cases_;
  std::vector<double> apartness_;  ///< apartness of every case, ascending
};

}  // namespace rubsweep::diagnose::forest
