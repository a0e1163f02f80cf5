#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace rubsweep::diagnose::forest {

/// Features of many samples as numbers of bins, which trees are grown on: every feature has bins with about
/// as many samples each.
struct BinnedFeatures {
  static constexpr int most_bins = 64;
  std::vector<std::vector<double>>
      edges{};  ///< of each feature, ascending; bin b is edges[b - 1] < x <= edges[b]
  std::vector<std::vector<std::uint8_t>> bin{};  ///< of each feature, one of every sample
};

/// `samples`: one row for each, one column for every feature; no NaN.
BinnedFeatures binned(const Eigen::MatrixXd& samples);

}  // namespace rubsweep::diagnose::forest
