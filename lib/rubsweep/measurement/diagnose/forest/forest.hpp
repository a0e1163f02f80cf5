#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::forest {

/// Features of many samples as bin numbers, on which trees are grown. The bins of a feature hold about
/// equally many samples.
struct BinnedFeatures {
  static constexpr int most_bins = 64;
  std::vector<std::vector<double>>
      edges{};  ///< edges of each feature, ascending; bin b is edges[b - 1] < x <= edges[b]
  std::vector<std::vector<std::uint8_t>> bin{};  ///< bin numbers: a vector per feature, an entry per sample
};

/// `samples`: one row per sample, one column per feature; no NaN.
BinnedFeatures binned(const Eigen::MatrixXd& samples);

/// Labelled samples from which a forest is grown.
struct LabelledSamples {
  Eigen::MatrixXd features{};  ///< one row per sample
  std::vector<int> label{};    ///< labels, counted from 0
  Eigen::VectorXd weight{};    ///< weights, > 0
  int classes = 0;
};

/// Limits for growing trees.
struct TreeOptions {
  int features_tried = 0;  ///< number of features tried at every split, drawn again for each
  int least_leaf = 1;      ///< fewest samples that a leaf keeps
};

/// Classification tree (Breiman, Friedman, Olshen, Stone 1984): every split minimises the Gini impurity of
/// the labels.
class Tree {
 public:
  /// Grows the tree on a bootstrap sample drawn by `random`.
  Tree(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
       RandomStream random);

  struct Member {
    int sample = 0;
    int times = 0;  ///< number of times the sample was drawn
  };
  /// Drawn samples in the leaf that belongs to these features.
  const std::vector<Member>& leaf_of(const Eigen::VectorXd& features) const;

  bool drew(int sample) const { return times_drawn_[static_cast<std::size_t>(sample)] > 0; }

 private:
  struct Node {
    int feature = -1;  ///< -1: a leaf
    double threshold = 0;
    int below = 0, above = 0;  ///< child nodes; in a leaf, its number
  };
  int grow(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
           RandomStream& random, std::vector<Member> members);

  std::vector<int> times_drawn_;  ///< for every sample
  std::vector<Node> nodes_;
  std::vector<std::vector<Member>> leaves_;
};

/// Linear discriminant functions of labelled samples (Fisher 1936). The function of a label is x^T C^-1 m:
/// features x, covariance C within the labels, mean m of the label. Features are in units of their standard
/// deviation, limited to 4. With fewer than ten samples per feature there are no functions, because they
/// would fit these samples only.
class LinearDiscriminants {
 public:
  explicit LinearDiscriminants(const LabelledSamples& samples);

  /// The features, one row per observation, and then the discriminant functions, one column per label.
  Eigen::MatrixXd beside(const Eigen::MatrixXd& features) const;

 private:
  Eigen::MatrixXd standard(const Eigen::MatrixXd& features) const;

  Eigen::RowVectorXd middle_, deviation_;
  Eigen::MatrixXd axes_;  ///< one column per label
};

struct ForestOptions {
  int trees = 200;
  int least_leaf = 3;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one thread per processor; does not change the result
};

/// Random forest (Breiman 2001) as the kernel of approximate Bayesian computation. Trees grow on all samples
/// alike and say which of them resemble an observation; the weights of the samples say how often the priors
/// draw such ones. (Weights hardly count while trees grow, because leaves of a full-grown tree hold a few
/// samples of mostly one label.) Samples that share leaves with an observation represent its posterior, both
/// of the candidate (Pudlo et al. 2016) and of the machine's parameters (Raynal et al. 2019). Linear
/// discriminant functions of the labels are further features, as Pudlo et al. advise.
class Forest {
 public:
  Forest(const LabelledSamples& samples, const ForestOptions& options);

  /// Weight of every sample in the posterior for these features; the weights add up to 1 (Meinshausen 2006,
  /// eq. 4).
  Eigen::VectorXd posterior_weights(const Eigen::VectorXd& features) const;

  /// Weights for one of the forest's own samples, from trees that did not draw it; empty if all drew it.
  Eigen::VectorXd out_of_bag_weights(int sample) const;

  /// Label probabilities of every sample from the trees that did not draw it: one row per sample.
  Eigen::MatrixXd out_of_bag_probabilities() const;

 private:
  /// `features` include the discriminant functions. Trees that drew the sample `without` are left out.
  Eigen::VectorXd weights(const Eigen::VectorXd& features, int without) const;

  LinearDiscriminants discriminants_;
  Eigen::MatrixXd features_;  ///< features with the discriminant functions
  std::vector<int> label_;
  Eigen::VectorXd weight_;
  int classes_ = 0, threads_ = 0;
  std::vector<Tree> trees_;
};

}  // namespace rubsweep::diagnose::forest
