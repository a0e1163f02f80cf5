#include "rubsweep/measurement/diagnose/forest/forest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::forest {
namespace {

std::vector<double> edges_of(std::vector<double> values) {
  std::ranges::sort(values);
  std::vector<double> edges;
  for (int b = 1; b < BinnedFeatures::most_bins; ++b) {
    const double edge = values[values.size() * static_cast<std::size_t>(b) / BinnedFeatures::most_bins];
    // An edge at the largest value would have no samples above it.
    if (edge < values.back() && (edges.empty() || edge > edges.back())) edges.push_back(edge);
  }
  return edges;
}

struct Split {
  int feature = -1, last_below = 0;  ///< bins up to this one go to the lower node
  double purity = 0;  ///< sum over both nodes of (sum of squared counts of labels) / count; larger is purer
};

/// Number of samples of every label on both sides of a split of one feature. The sums grow bin by bin, so
/// that all splits are compared in one pass.
class SplitSearch {
 public:
  SplitSearch(const LabelledSamples& samples, int least_leaf)
      : samples_(samples),
        least_leaf_(least_leaf),
        by_bin_(static_cast<std::size_t>(BinnedFeatures::most_bins * samples.classes)) {}

  void look(int feature, const std::vector<std::uint8_t>& bin, int bins,
            const std::vector<Tree::Member>& members, const std::vector<double>& by_class, Split& best) {
    const std::size_t classes = by_class.size();
    std::fill_n(by_bin_.begin(), static_cast<std::size_t>(bins) * classes, 0.0);
    std::array<int, BinnedFeatures::most_bins> count{};
    for (const auto& [sample, times] : members) {
      const auto s = static_cast<std::size_t>(sample);
      by_bin_[bin[s] * classes + static_cast<std::size_t>(samples_.label[s])] += times;
      ++count[bin[s]];
    }
    above_ = by_class;
    below_.assign(classes, 0.0);
    int left = 0;
    for (int b = 0; b + 1 < bins; ++b) {
      const auto here = static_cast<std::size_t>(b);
      if (count[here] == 0) continue;  // the same split as at the bin before
      left += count[here];
      for (std::size_t c = 0; c < classes; ++c) {
        const double moved = by_bin_[here * classes + c];
        below_[c] += moved;
        above_[c] -= moved;
      }
      if (static_cast<int>(members.size()) - left < least_leaf_) return;
      if (left < least_leaf_) continue;
      const double purity = purity_of(below_) + purity_of(above_);
      if (purity > best.purity) best = {feature, b, purity};
    }
  }

  static double purity_of(const std::vector<double>& counts) {
    double sum = 0, squares = 0;
    for (const double n : counts) {
      sum += n;
      squares += n * n;
    }
    return sum > 0 ? squares / sum : 0;
  }

 private:
  const LabelledSamples& samples_;
  int least_leaf_;
  std::vector<double> by_bin_, below_{}, above_{};
};

int drawn_below(int count, RandomStream& random) { return static_cast<int>(random.uniform() * count); }

/// Weighted mean of the features for each label, one row per label; zero for a label without samples.
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

/// Weighted covariance of the features about the means of their labels.
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

BinnedFeatures binned(const Eigen::MatrixXd& samples) {
  BinnedFeatures features;
  for (const auto column : samples.colwise()) {
    const std::vector<double> values(column.begin(), column.end());
    std::vector<double> edges = values.empty() ? std::vector<double>{} : edges_of(values);
    std::vector<std::uint8_t> bin;
    bin.reserve(values.size());
    for (const double x : values)
      bin.push_back(static_cast<std::uint8_t>(std::ranges::lower_bound(edges, x) - edges.begin()));
    features.edges.push_back(std::move(edges));
    features.bin.push_back(std::move(bin));
  }
  return features;
}

Tree::Tree(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
           RandomStream random)
    : times_drawn_(samples.label.size(), 0) {
  const int count = static_cast<int>(samples.label.size());
  for (int i = 0; i < count; ++i) ++times_drawn_[static_cast<std::size_t>(drawn_below(count, random))];
  std::vector<Member> members;
  for (int i = 0; i < count; ++i)
    if (drew(i)) members.push_back({i, times_drawn_[static_cast<std::size_t>(i)]});
  grow(samples, binned, options, random, std::move(members));
}

int Tree::grow(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
               RandomStream& random, std::vector<Member> members) {
  const int here = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  std::vector<double> by_class(static_cast<std::size_t>(samples.classes), 0.0);
  for (const auto& [sample, times] : members)
    by_class[static_cast<std::size_t>(samples.label[static_cast<std::size_t>(sample)])] += times;
  const bool mixed = std::ranges::count_if(by_class, [](double times) { return times > 0; }) > 1;
  Split best{.purity = SplitSearch::purity_of(by_class) * (1 + 1e-12)};
  if (mixed && static_cast<int>(members.size()) >= 2 * options.least_leaf) {
    SplitSearch search(samples, options.least_leaf);
    for (int t = 0; t < options.features_tried; ++t) {
      const auto f = static_cast<std::size_t>(drawn_below(static_cast<int>(binned.bin.size()), random));
      search.look(static_cast<int>(f), binned.bin[f], static_cast<int>(binned.edges[f].size()) + 1, members,
                  by_class, best);
    }
  }
  Node node;
  if (best.feature < 0) {
    node.below = static_cast<int>(leaves_.size());
    leaves_.push_back(std::move(members));
  } else {
    const auto f = static_cast<std::size_t>(best.feature);
    node.feature = best.feature;
    node.threshold = binned.edges[f][static_cast<std::size_t>(best.last_below)];
    const auto middle = std::stable_partition(members.begin(), members.end(), [&](const Member& member) {
      return binned.bin[f][static_cast<std::size_t>(member.sample)] <= best.last_below;
    });
    std::vector<Member> above(middle, members.end());
    members.erase(middle, members.end());
    node.below = grow(samples, binned, options, random, std::move(members));
    node.above = grow(samples, binned, options, random, std::move(above));
  }
  nodes_[static_cast<std::size_t>(here)] = node;
  return here;
}

const std::vector<Tree::Member>& Tree::leaf_of(const Eigen::VectorXd& features) const {
  std::size_t at = 0;
  while (nodes_[at].feature >= 0)
    at = static_cast<std::size_t>(features(nodes_[at].feature) <= nodes_[at].threshold ? nodes_[at].below
                                                                                       : nodes_[at].above);
  return leaves_[static_cast<std::size_t>(nodes_[at].below)];
}

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
  // Ridge added to the diagonal, because the covariance of linearly dependent features is singular.
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
      weight_(samples.weight),
      classes_(samples.classes),
      threads_(options.threads) {
  const BinnedFeatures bins = binned(features_);
  const TreeOptions tree_options{std::max(1, static_cast<int>(features_.cols()) / 3), options.least_leaf};
  std::vector<std::optional<Tree>> grown(static_cast<std::size_t>(options.trees));
  batch::parallel_run(grown.size(), threads_, [&](std::size_t k) {
    grown[k].emplace(samples, bins, tree_options, RandomStream(options.seed, k, DrawPurpose::of_tree));
  });
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
    for (const Tree::Member& member : leaf) all += member.times;
    for (const Tree::Member& member : leaf) sum(member.sample) += member.times / all;
  }
  if (counted == 0) return {};
  sum.array() *= weight_.array();
  return sum / sum.sum();
}

Eigen::VectorXd Forest::posterior_weights(const Eigen::VectorXd& features) const {
  return weights(discriminants_.beside(features.transpose()).transpose(), -1);
}

Eigen::VectorXd Forest::out_of_bag_weights(int sample) const {
  return weights(features_.row(sample), sample);
}

Eigen::MatrixXd Forest::out_of_bag_probabilities() const {
  Eigen::MatrixXd probability = Eigen::MatrixXd::Zero(features_.rows(), classes_);
  batch::parallel_run(static_cast<std::size_t>(features_.rows()), threads_, [&](std::size_t i) {
    const Eigen::VectorXd weight = out_of_bag_weights(static_cast<int>(i));
    for (Eigen::Index j = 0; j < weight.size(); ++j)
      probability(static_cast<Eigen::Index>(i), label_[static_cast<std::size_t>(j)]) += weight(j);
  });
  return probability;
}

}  // namespace rubsweep::diagnose::forest
