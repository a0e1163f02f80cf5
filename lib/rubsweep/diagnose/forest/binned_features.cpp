#include "rubsweep/diagnose/forest/binned_features.hpp"

#include <algorithm>
#include <cstddef>

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

}  // namespace rubsweep::diagnose::forest
