#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::forest {

/// Features of many samples as numbers of bins, which trees are grown on: every feature has bins with about
/// as many samples each.
struct BinnedFeatures {
  static constexpr int most_bins = 64;
  std::vector<std::vector<double>>
      edges{};  ///< edges of each feature, ascending; bin b is edges[b - 1] < x <= edges[b]
  std::vector<std::vector<std::uint8_t>> bin{};  ///< bins of each feature, one of every sample
};

/// `samples`: one row for each, one column for every feature; no NaN.
BinnedFeatures binned(const Eigen::MatrixXd& samples);

/// Samples that a forest is grown on.
struct LabelledSamples {
  Eigen::MatrixXd features{};  ///< a row for each sample
  std::vector<int> label{};    ///< label counted from 0
  Eigen::VectorXd weight{};    ///< > 0
  int classes = 0;
};

/// How trees are grown.
struct TreeOptions {
  int features_tried = 0;  ///< features tried at every split, drawn anew
  int least_leaf = 1;      ///< fewest samples that a leaf keeps
};

/// Classification tree (Breiman, Friedman, Olshen, Stone 1984): every split is the one that leaves the least
/// Gini impurity of the weighted labels.
class Tree {
 public:
  /// Grown on a bootstrap sample, which `random` draws.
  Tree(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
       RandomStream random);

  struct Member {
    int sample = 0;
    double weight = 0;  ///< times it was drawn x its own weight
  };
  /// Drawn samples in the leaf that features lead to.
  const std::vector<Member>& leaf_of(const Eigen::VectorXd& features) const;

  bool drew(int sample) const { return weight_[static_cast<std::size_t>(sample)] > 0; }

 private:
  struct Node {
    int feature = -1;  ///< -1: a leaf
    double threshold = 0;
    int below = 0, above = 0;  ///< nodes, or of a leaf its number
  };
  int grow(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
           RandomStream& random, std::vector<int> members);

  std::vector<double> weight_;  ///< weight of every sample: times it was drawn x its own
  std::vector<Node> nodes_;
  std::vector<std::vector<Member>> leaves_;
};

}  // namespace rubsweep::diagnose::forest
