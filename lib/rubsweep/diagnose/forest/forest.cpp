#include "rubsweep/diagnose/forest/forest.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>

#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/diagnose/draw_purpose.hpp"

namespace rubsweep::diagnose::forest {

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
