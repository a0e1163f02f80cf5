#include "rubsweep/measurement/diagnose/forest/forest.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::forest {
namespace {

/// Weighted means of the rows of each label, a row for each; zero where none has it.
Eigen::MatrixXd means_of(const LabelledSamples& samples, const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(samples.classes, rows.cols());
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(samples.classes);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const int label = samples.label[static_cast<std::size_t>(i)];
    mean.row(label) += samples.weight(i) * rows.row(i);
    weight(label) += samples.weight(i);
  }
  for (Eigen::Index c = 0; c < mean.rows(); ++c)
    if (weight(c) > 0) mean.row(c) /= weight(c);
  return mean;
}

/// Weighted covariance of the rows about the means of their labels.
Eigen::MatrixXd covariance_within(const LabelledSamples& samples, const Eigen::MatrixXd& rows,
                                  const Eigen::MatrixXd& mean) {
  const double all = samples.weight.sum();
  Eigen::MatrixXd scaled(rows.rows(), rows.cols());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    scaled.row(i) = std::sqrt(samples.weight(i) / all) *
                    (rows.row(i) - mean.row(samples.label[static_cast<std::size_t>(i)]));
  return scaled.transpose() * scaled;
}

}  // namespace

LinearDiscriminants::LinearDiscriminants(const LabelledSamples& samples) {
  constexpr Eigen::Index samples_of_a_feature = 10;
  axes_.resize(samples.features.cols(), 0);
  if (samples.features.rows() < samples_of_a_feature * samples.features.cols()) return;
  constexpr double least_deviation = 1e-9;
  middle_ = samples.features.colwise().mean();
  deviation_ =
      (samples.features.rowwise() - middle_).array().square().colwise().mean().sqrt() + least_deviation;
  const Eigen::MatrixXd rows = standard(samples.features), mean = means_of(samples, rows);
  Eigen::MatrixXd covariance = covariance_within(samples, rows, mean);
  // The covariance of features that depend on each other is singular.
  constexpr double ridge = 0.01;
  covariance.diagonal().array() += ridge;
  axes_ = numerics::dense::CholeskyFactors(covariance).solve(Eigen::MatrixXd(mean.transpose()));
}

Eigen::MatrixXd LinearDiscriminants::standard(const Eigen::MatrixXd& features) const {
  constexpr double most_deviations = 4;
  const Eigen::ArrayXXd rows = (features.rowwise() - middle_).array().rowwise() / deviation_.array();
  return rows.max(-most_deviations).min(most_deviations);
}

Eigen::MatrixXd LinearDiscriminants::beside(const Eigen::MatrixXd& features) const {
  if (axes_.cols() == 0) return features;
  Eigen::MatrixXd both(features.rows(), features.cols() + axes_.cols());
  both << features, standard(features) * axes_;
  return both;
}

Forest::Forest(const LabelledSamples& samples, const ForestOptions& options)
    : discriminants_(samples),
      features_(discriminants_.beside(samples.features)),
      label_(samples.label),
      classes_(samples.classes),
      threads_(options.threads) {
  const BinnedFeatures bins = binned(features_);
  const TreeOptions tree_options{std::max(1, static_cast<int>(features_.cols()) / 3), options.least_leaf};
  std::vector<std::optional<Tree>> grown(static_cast<std::size_t>(options.trees));
  batch::parallel_run(
      grown.size(), threads_,
      [&](std::size_t k) {
        grown[k].emplace(samples, bins, tree_options, RandomStream(options.seed, k, DrawPurpose::of_tree));
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  for (auto& tree : grown) trees_.push_back(*std::move(tree));
}

Eigen::VectorXd Forest::weights(const Eigen::VectorXd& features, int without) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(features_.rows());
  int counted = 0;
  for (const Tree& tree : trees_) {
    if (without >= 0 && tree.drew(without)) continue;
    ++counted;
    const auto& leaf = tree.leaf_of(features);
    double all = 0;
    for (const Tree::Member& member : leaf) all += member.weight;
    for (const Tree::Member& member : leaf) sum(member.sample) += member.weight / all;
  }
  if (counted == 0) return {};
  return sum / counted;
}

Eigen::VectorXd Forest::posterior_weights(const Eigen::VectorXd& features) const {
  return weights(discriminants_.beside(features.transpose()).transpose(), -1);
}

Eigen::VectorXd Forest::out_of_bag_weights(int sample) const {
  return weights(features_.row(sample), sample);
}

Eigen::MatrixXd Forest::out_of_bag_probabilities() const {
  Eigen::MatrixXd probability = Eigen::MatrixXd::Zero(features_.rows(), classes_);
  batch::parallel_run(
      static_cast<std::size_t>(features_.rows()), threads_,
      [&](std::size_t i) {
        const Eigen::VectorXd weight = out_of_bag_weights(static_cast<int>(i));
        for (Eigen::Index j = 0; j < weight.size(); ++j)
          probability(static_cast<Eigen::Index>(i), label_[static_cast<std::size_t>(j)]) += weight(j);
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  return probability;
}

}  // namespace rubsweep::diagnose::forest
