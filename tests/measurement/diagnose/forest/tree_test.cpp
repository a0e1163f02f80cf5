#include "rubsweep/measurement/diagnose/forest/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "two_clouds.hpp"

namespace rubsweep::diagnose::forest {
namespace {

TEST(Tree, PartsSamplesThatCanBeParted) {
  LabelledSamples samples{Eigen::MatrixXd(40, 1), {}, Eigen::VectorXd::Ones(40), 2};
  for (int i = 0; i < 40; ++i) {
    samples.features(i, 0) = i;
    samples.label.push_back(i < 17 ? 0 : 1);
  }
  const Tree tree(samples, binned(samples.features), {1, 1}, RandomStream(1, 0, 0));
  for (int i : {0, 5, 12, 22, 30, 39})
    for (const Tree::Member& member : tree.leaf_of(samples.features.row(i)))
      EXPECT_EQ(samples.label[static_cast<std::size_t>(member.sample)],
                samples.label[static_cast<std::size_t>(i)]);
}

TEST(Tree, KeepsItsLeavesLarge) {
  const LabelledSamples samples = two_clouds(500, 1);
  const Tree tree(samples, binned(samples.features), {2, 20}, RandomStream(2, 0, 0));
  for (int i = 0; i < 500; ++i) EXPECT_GE(tree.leaf_of(samples.features.row(i)).size(), 20U);
}

TEST(Tree, DrawsTwoThirdsOfTheSamples) {
  const LabelledSamples samples = two_clouds(3000, 1);
  const Tree tree(samples, binned(samples.features), {1, 50}, RandomStream(3, 0, 0));
  int drawn = 0;
  for (int i = 0; i < 3000; ++i) drawn += tree.drew(i);
  EXPECT_NEAR(drawn / 3000.0, 1 - std::exp(-1), 0.03);
}

TEST(Tree, HaveAboutAsManySamplesEach) {
  Eigen::MatrixXd samples(6400, 1);
  for (int i = 0; i < 6400; ++i) samples(i, 0) = i * i;
  const BinnedFeatures features = binned(samples);
  ASSERT_EQ(features.edges[0].size(), 63U);
  for (std::uint8_t b = 0; b < 64; ++b)
    EXPECT_NEAR(static_cast<double>(std::ranges::count(features.bin[0], b)), 100, 1);
}

TEST(Tree, OfFewValuesHaveABinForEach) {
  Eigen::MatrixXd samples(90, 1);
  for (int i = 0; i < 90; ++i) samples(i, 0) = i % 3;
  const BinnedFeatures features = binned(samples);
  EXPECT_EQ(features.edges[0], (std::vector<double>{0, 1}));
  for (std::size_t i = 0; i < 90; ++i) EXPECT_EQ(features.bin[0][i], i % 3);
}

TEST(Tree, OfOneValueHaveNoEdge) { EXPECT_TRUE(binned(Eigen::MatrixXd::Ones(10, 1)).edges[0].empty()); }

}  // namespace
}  // namespace rubsweep::diagnose::forest
