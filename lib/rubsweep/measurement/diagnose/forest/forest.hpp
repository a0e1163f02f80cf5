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

/// Linear discriminant functions of labelled samples (Fisher 1936): for every label the projection of the
/// features on the inverse of the covariance within the labels times their mean under this label. Features
/// count in units of their standard deviation, up to four of them. Where there are fewer than ten samples for
/// each feature there are none: they would separate these samples and no others.
class LinearDiscriminants {
 public:
  explicit LinearDiscriminants(const LabelledSamples& samples);

  /// Features, a row for each observation, and beside them the functions, a column for each label.
  Eigen::MatrixXd beside(const Eigen::MatrixXd& features) const;

 private:
  Eigen::MatrixXd standard(const Eigen::MatrixXd& features) const;

  Eigen::RowVectorXd middle_, deviation_;
  Eigen::MatrixXd axes_;  ///< a column for each label
};

struct ForestOptions {
  int trees = 200;
  int least_leaf = 3;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one for every processor; decides no result
};

/// Random forest (Breiman 2001) as the kernel of approximate Bayesian computation: samples are drawn from
/// priors, and those that share leaves with an observation are draws from its posterior, the candidate (Pudlo
/// et al. 2016) and the numbers of the machine (Raynal et al. 2019) alike. Linear discriminant functions of
/// the labels stand beside the features, as Pudlo et al. advise.
class Forest {
 public:
  Forest(const LabelledSamples& samples, const ForestOptions& options);

  /// Weight of every sample in the posterior of these features; they add up to 1 (Meinshausen 2006, eq. 4).
  Eigen::VectorXd posterior_weights(const Eigen::VectorXd& features) const;

  /// The same for one of its own samples, by the trees that did not draw it; empty where all did.
  Eigen::VectorXd out_of_bag_weights(int sample) const;

  /// Probabilities of the labels of every sample by the trees that did not draw it: a row for each.
  Eigen::MatrixXd out_of_bag_probabilities() const;

 private:
  /// `features`: with the discriminants.
  Eigen::VectorXd weights(const Eigen::VectorXd& features, int without) const;

  LinearDiscriminants discriminants_;
  Eigen::MatrixXd features_;  ///< features with the discriminants
  std::vector<int> label_;
  int classes_ = 0, threads_ = 0;
  std::vector<Tree> trees_;
};

}  // namespace rubsweep::diagnose::forest
