#include "rubsweep/page/needed_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubsweep::page {
namespace {

using Signals = std::vector<std::vector<double>>;

std::vector<double> circle(int steps) {
  std::vector<double> values;
  for (int k = 0; k <= steps; ++k) values.push_back(std::cos(2 * std::numbers::pi * k / steps));
  return values;
}

/// The largest distance of a sample from the straight line between its kept neighbours, sample by sample.
double largest_distance(const std::vector<double>& signal, const std::vector<std::size_t>& kept) {
  double largest = 0;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const auto next = std::upper_bound(kept.begin(), kept.end(), k);
    if (next == kept.end()) continue;
    const std::size_t a = *(next - 1), b = *next;
    const double slope = (signal[b] - signal[a]) / static_cast<double>(b - a);
    largest = std::max(largest, std::abs(signal[k] - signal[a] - slope * static_cast<double>(k - a)));
  }
  return largest;
}

TEST(NeededSamples, AStraightLineNeedsItsEnds) {
  const Signals signals{{0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(needed_samples(signals, 1e-12, {}), (std::vector<std::size_t>{0, 5}));
}

TEST(NeededSamples, ACornerStays) {
  const Signals signals{{0, 0, 0, 1, 2, 3}, {5, 5, 5, 5, 5, 5}};
  EXPECT_EQ(needed_samples(signals, 1e-12, {}), (std::vector<std::size_t>{0, 2, 5}));
}

TEST(NeededSamples, NoSampleIsMissedByMoreThanTheTolerance) {
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-5}) {
    Signals signals{circle(512), circle(512)};
    for (std::size_t k = 0; k < signals[1].size(); ++k) signals[1][k] = std::abs(signals[1][k]) - 0.3;
    const auto kept = needed_samples(signals, tolerance, {});
    for (const auto& signal : signals) EXPECT_LE(largest_distance(signal, kept), tolerance);
  }
}

TEST(NeededSamples, ACircleTakesAboutAsManyAsItsSagittaSays) {
  // Chords of a cosine that miss it by at most e: arcs of about sqrt(8 e) where it bends most.
  const Signals signals{circle(512)};
  const auto kept = needed_samples(signals, 2.5e-3, {});
  EXPECT_GT(kept.size(), 20u);
  EXPECT_LT(kept.size(), 60u);
}

TEST(NeededSamples, AskedOnesStayAndAllAscend) {
  const Signals signals{{0, 1, 2, 3, 4, 5}};
  const std::vector<std::size_t> always{0, 2, 3, 5};
  EXPECT_EQ(needed_samples(signals, 1e-12, always), always);
}

}  // namespace
}  // namespace rubsweep::page
