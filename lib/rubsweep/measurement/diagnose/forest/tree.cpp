#include "rubsweep/measurement/diagnose/forest/tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace rubsweep::diagnose::forest {
namespace {

std::vector<double> edges_of(std::vector<double> values) {
  std::ranges::sort(values);
  std::vector<double> edges;
  for (int b = 1; b < BinnedFeatures::most_bins; ++b) {
    const double edge = values[values.size() * static_cast<std::size_t>(b) / BinnedFeatures::most_bins];
    // Nothing lies above the largest value.
    if (edge < values.back() && (edges.empty() || edge > edges.back())) edges.push_back(edge);
  }
  return edges;
}

struct Split {
  int feature = -1, last_below = 0;  ///< bins up to this one go below
  double purity = 0;  ///< sum over both sides of (sum of squares of the labels' weights) / weight
};

/// Weight and number of samples of every label in every bin of one feature, added up bin by bin to find the
/// best split.
class SplitSearch {
 public:
  SplitSearch(const LabelledSamples& samples, const std::vector<double>& weight, int least_leaf)
      : samples_(samples),
        weight_(weight),
        least_leaf_(least_leaf),
        by_bin_(static_cast<std::size_t>(BinnedFeatures::most_bins * samples.classes)) {}

  void look(int feature, const std::vector<std::uint8_t>& bin, int bins, const std::vector<int>& members,
            Split& best) {
    const auto classes = static_cast<std::size_t>(samples_.classes);
    std::fill_n(by_bin_.begin(), static_cast<std::size_t>(bins) * classes, 0.0);
    std::array<int, BinnedFeatures::most_bins> count{};
    std::vector<double> above(classes, 0.0), below(classes, 0.0);
    for (const int i : members) {
      const auto s = static_cast<std::size_t>(i);
      const auto label = static_cast<std::size_t>(samples_.label[s]);
      by_bin_[bin[s] * classes + label] += weight_[s];
      above[label] += weight_[s];
      ++count[bin[s]];
    }
    int left = 0;
    for (int b = 0; b + 1 < bins; ++b) {
      left += count[static_cast<std::size_t>(b)];
      for (std::size_t c = 0; c < classes; ++c) {
        const double moved = by_bin_[static_cast<std::size_t>(b) * classes + c];
        below[c] += moved;
        above[c] -= moved;
      }
      if (left < least_leaf_ || static_cast<int>(members.size()) - left < least_leaf_) continue;
      const double purity = purity_of(below) + purity_of(above);
      if (purity > best.purity) best = {feature, b, purity};
    }
  }

  static double purity_of(const std::vector<double>& weights) {
    double sum = 0, squares = 0;
    for (const double w : weights) {
      sum += w;
      squares += w * w;
    }
    return sum > 0 ? squares / sum : 0;
  }

 private:
  const LabelledSamples& samples_;
  const std::vector<double>& weight_;
  int least_leaf_;
  std::vector<double> by_bin_;
};

int drawn_below(int count, RandomStream& random) { return static_cast<int>(random.uniform() * count); }

}  // namespace

BinnedFeatures binned(const Eigen::MatrixXd& samples) {
  BinnedFeatures features;
  for (const auto column : samples.colwise()) {
    const std::vector<double> values(column.begin(), column.end());
    std::vector<double> edges = values.empty() ? std::vector<double>{} : edges_of(values);
    std::vector<std::uint8_t> bin;
    for (const double x : values)
      bin.push_back(static_cast<std::uint8_t>(std::ranges::lower_bound(edges, x) - edges.begin()));
    features.edges.push_back(std::move(edges));
    features.bin.push_back(std::move(bin));
  }
  return features;
}

Tree::Tree(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
           RandomStream random)
    : weight_(samples.label.size(), 0.0) {
  const int count = static_cast<int>(samples.label.size());
  for (int i = 0; i < count; ++i) {
    const int drawn = drawn_below(count, random);
    weight_[static_cast<std::size_t>(drawn)] += samples.weight(drawn);
  }
  std::vector<int> members;
  for (int i = 0; i < count; ++i)
    if (drew(i)) members.push_back(i);
  grow(samples, binned, options, random, std::move(members));
}

int Tree::grow(const LabelledSamples& samples, const BinnedFeatures& binned, const TreeOptions& options,
               RandomStream& random, std::vector<int> members) {
  const int here = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  std::vector<double> by_class(static_cast<std::size_t>(samples.classes), 0.0);
  for (const int i : members) {
    const auto s = static_cast<std::size_t>(i);
    by_class[static_cast<std::size_t>(samples.label[s])] += weight_[s];
  }
  Split best{.purity = SplitSearch::purity_of(by_class) * (1 + 1e-12)};
  if (static_cast<int>(members.size()) >= 2 * options.least_leaf) {
    SplitSearch search(samples, weight_, options.least_leaf);
    for (int t = 0; t < options.features_tried; ++t) {
      const auto f = static_cast<std::size_t>(drawn_below(static_cast<int>(binned.bin.size()), random));
      search.look(static_cast<int>(f), binned.bin[f], static_cast<int>(binned.edges[f].size()) + 1, members,
                  best);
    }
  }
  Node node;
  if (best.feature < 0) {
    node.below = static_cast<int>(leaves_.size());
    auto& leaf = leaves_.emplace_back();
    for (const int i : members) leaf.push_back({i, weight_[static_cast<std::size_t>(i)]});
  } else {
    const auto f = static_cast<std::size_t>(best.feature);
    node.feature = best.feature;
    node.threshold = binned.edges[f][static_cast<std::size_t>(best.last_below)];
    const auto middle = std::stable_partition(members.begin(), members.end(), [&](int i) {
      return binned.bin[f][static_cast<std::size_t>(i)] <= best.last_below;
    });
    std::vector<int> above(middle, members.end());
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

}  // namespace rubsweep::diagnose::forest
