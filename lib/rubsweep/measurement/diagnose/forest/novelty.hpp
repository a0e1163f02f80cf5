#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace rubsweep::diagnose::forest {

/// Test whether an observation is one of a population that simulated cases are drawn from: its mean distance
/// to the nearest of them, over the mean distance that those have to theirs (the local outlier factor of
/// Breunig, Kriegel, Ng, Sander 2000 without its smoothing), is compared with that of each of them (conformal
/// prediction; Vovk, Gammerman, Shafer 2005). Distances are those of features in units of their spread in the
/// population.
class Novelty {
 public:
  /// A row for each case, a column for every feature.
  explicit Novelty(const Eigen::MatrixXd& cases, int threads = 0);

  /// Share of cases that stand as far apart from the others, in (0, 1]: evenly distributed for observations
  /// of the population.
  double p_value(const Eigen::VectorXd& features) const;

 private:
  static constexpr std::size_t neighbours = 3;
  /// The nearest cases and their distances, ascending; one more than count, as one may be left out.
  using Nearest = std::array<std::pair<double, Eigen::Index>, neighbours + 1>;
  Nearest nearest(const Eigen::VectorXd& scaled, Eigen::Index without) const;
  /// `self`: the case itself, which its neighbours must not count; -1 for a new observation.
  double apartness(const Nearest& nearest, Eigen::Index self) const;
  Eigen::VectorXd scaled(const Eigen::VectorXd& features) const;

  Eigen::VectorXd middle_, spread_;
  Eigen::MatrixXd cases_;  ///< scaled, a column for each case
  std::vector<Nearest> of_cases_;
  std::vector<double> apartness_;  ///< apartness of every case, ascending
};

}  // namespace rubsweep::diagnose::forest
