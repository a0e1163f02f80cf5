#include "rubsweep/diagnose/forest/tree.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace rubsweep::diagnose::forest
