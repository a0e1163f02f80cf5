#include "rubsweep/diagnose/forest/binned_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rubsweep::diagnose::forest {
namespace {

TEST(BinnedFeatures, HaveAboutAsManySamplesEach) {
  Eigen::MatrixXd samples(6400, 1);
  for (int i = 0; i < 6400; ++i) samples(i, 0) = i * i;
  const BinnedFeatures features = binned(samples);
  ASSERT_EQ(features.edges[0].size(), 63U);
  for (std::uint8_t b = 0; b < 64; ++b)
    EXPECT_NEAR(static_cast<double>(std::ranges::count(features.bin[0], b)), 100, 1);
}

TEST(BinnedFeatures, OfFewValuesHaveABinForEach) {
  Eigen::MatrixXd samples(90, 1);
  for (int i = 0; i < 90; ++i) samples(i, 0) = i % 3;
  const BinnedFeatures features = binned(samples);
  EXPECT_EQ(features.edges[0], (std::vector<double>{0, 1}));
  for (std::size_t i = 0; i < 90; ++i) EXPECT_EQ(features.bin[0][i], i % 3);
}

TEST(BinnedFeatures, OfOneValueHaveNoEdge) {
  EXPECT_TRUE(binned(Eigen::MatrixXd::Ones(10, 1)).edges[0].empty());
}

}  // namespace
}  // namespace rubsweep::diagnose::forest
