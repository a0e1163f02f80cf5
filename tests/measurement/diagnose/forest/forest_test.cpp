#include "rubsweep/measurement/diagnose/forest/forest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "two_clouds.hpp"

namespace rubsweep::diagnose::forest {
namespace {

double probability_of_second(const Forest& forest, const LabelledSamples& samples, double x) {
  const Eigen::VectorXd weight = forest.posterior_weights(Eigen::Vector2d(x, 0));
  double sum = 0;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (samples.label[static_cast<std::size_t>(i)] == 1) sum += weight(i);
  return sum;
}

TEST(Forest, GivesTheProbabilityOfBayesTheorem) {
  const LabelledSamples samples = two_clouds(6000, 1);
  const Forest forest(samples, {.least_leaf = 25});
  for (const double x : {-2.0, -1.0, -0.3, 0.3, 1.0, 2.0})
    EXPECT_NEAR(probability_of_second(forest, samples, x), second_cloud(x), 0.06) << x;
}

TEST(Forest, MindsTheWeightsOfTheSamples) {
  LabelledSamples samples = two_clouds(6000, 2);
  for (Eigen::Index i = 0; i < samples.weight.size(); ++i)
    if (samples.label[static_cast<std::size_t>(i)] == 1) samples.weight(i) = 3;
  const Forest forest(samples, {.least_leaf = 25});
  for (const double x : {-1.0, 0.0, 1.0})
    EXPECT_NEAR(probability_of_second(forest, samples, x), second_cloud(x, 3), 0.06) << x;
}

TEST(Forest, MindsTheWeightsInFullGrownTrees) {
  LabelledSamples samples = two_clouds(6000, 2);
  for (Eigen::Index i = 0; i < samples.weight.size(); ++i)
    if (samples.label[static_cast<std::size_t>(i)] == 1) samples.weight(i) = 5;
  const Forest forest(samples, {});
  // Such trees follow single samples, so that the mean over many places is compared.
  double told = 0, expected = 0;
  for (int k = 0; k < 40; ++k) {
    const double x = -1.2 + 0.02 * k;
    told += probability_of_second(forest, samples, x) / 40;
    expected += second_cloud(x, 5) / 40;
  }
  EXPECT_NEAR(told, expected, 0.05);
}

TEST(Forest, WeighsAllSamplesTogetherAsOne) {
  const Forest forest(two_clouds(300, 3), {});
  EXPECT_NEAR(forest.posterior_weights(Eigen::Vector2d(0.4, 1)).sum(), 1, 1e-12);
  EXPECT_NEAR(forest.out_of_bag_weights(7).sum(), 1, 1e-12);
  EXPECT_EQ(forest.out_of_bag_weights(7)(7), 0);
}

TEST(Forest, IsAsSureOfSamplesItDidNotDrawAsOfNewOnes) {
  const LabelledSamples samples = two_clouds(2000, 4);
  const Forest forest(samples, {.least_leaf = 10});
  const Eigen::MatrixXd told = forest.out_of_bag_probabilities();
  double error = 0;
  for (Eigen::Index i = 0; i < told.rows(); ++i)
    error += std::abs(told(i, 1) - second_cloud(samples.features(i, 0)));
  EXPECT_LT(error / static_cast<double>(told.rows()), 0.08);
}

TEST(Forest, SeesWhatNoFeatureAloneTells) {
  const LabelledSamples samples = slanting_clouds(300, 6);
  const Eigen::MatrixXd told = Forest(samples, {}).out_of_bag_probabilities();
  double right = 0;
  for (Eigen::Index i = 0; i < told.rows(); ++i)
    right += told(i, samples.label[static_cast<std::size_t>(i)]) / static_cast<double>(told.rows());
  EXPECT_GT(right, 0.98);
}

TEST(Forest, DoesNotDependOnThreads) {
  const LabelledSamples samples = two_clouds(400, 5);
  const Eigen::Vector2d here(0.2, -0.1);
  EXPECT_EQ(Forest(samples, {.threads = 1}).posterior_weights(here),
            Forest(samples, {.threads = 3}).posterior_weights(here));
}

/// Difference between the discriminant functions of the second and the first label.
Eigen::VectorXd second_over_first(const LinearDiscriminants& functions, const Eigen::MatrixXd& features) {
  const Eigen::MatrixXd both = functions.beside(features);
  return both.col(features.cols() + 1) - both.col(features.cols());
}

TEST(Forest, StandBesideTheFeatures) {
  const LabelledSamples samples = two_clouds(500, 1);
  const Eigen::MatrixXd both = LinearDiscriminants(samples).beside(samples.features);
  ASSERT_EQ(both.cols(), 4);
  EXPECT_EQ(both.leftCols(2), samples.features);
}

/// With unit covariance and a distance of 2, the difference is the logarithm of the odds by Bayes' theorem.
/// The first feature is scaled by its deviation over both clouds, sqrt(2); the ridge is small.
TEST(Forest, OfTwoNormalDistributionsAreTheLogarithmOfTheOdds) {
  const LinearDiscriminants functions(two_clouds(40000, 2));
  for (const double x : {-1.5, 0.4, 2.0}) {
    const Eigen::MatrixXd here = Eigen::RowVector2d(x, 0.7);
    EXPECT_NEAR(second_over_first(functions, here)(0), std::log(second_cloud(x) / (1 - second_cloud(x))),
                0.08 + 0.03 * std::abs(2 * x))
        << x;
  }
}

TEST(Forest, SeeWhatNoFeatureAloneTells) {
  const LabelledSamples samples = slanting_clouds(1000, 3);
  const Eigen::VectorXd above = second_over_first(LinearDiscriminants(samples), samples.features);
  double least = INFINITY, most = -INFINITY;
  for (Eigen::Index i = 0; i < above.size(); ++i) {
    if (samples.label[static_cast<std::size_t>(i)] == 1) least = std::min(least, above(i));
    if (samples.label[static_cast<std::size_t>(i)] == 0) most = std::max(most, above(i));
  }
  EXPECT_GT(least, most);
}

TEST(Forest, MindTheWeightsOfTheSamples) {
  // Distant samples without weight have no influence.
  LabelledSamples samples = two_clouds(2000, 4), less = samples;
  for (Eigen::Index i = 0; i < 2000; i += 5) {
    samples.features(i, 0) = 2 - samples.features(i, 0);
    samples.weight(i) = 1e-12;
    less.weight(i) = 1e-12;
  }
  const auto slope = [](const LabelledSamples& all) {
    const Eigen::Vector2d ends = second_over_first(LinearDiscriminants(all), Eigen::Matrix2d{{0, 0}, {1, 0}});
    return ends(1) - ends(0);
  };
  EXPECT_NEAR(slope(samples), slope(less), 0.02 * slope(less));
}

TEST(Forest, AreLeftOutWhereSamplesAreTooFew) {
  const LabelledSamples samples = two_clouds(19, 7);
  EXPECT_EQ(LinearDiscriminants(samples).beside(samples.features), samples.features);
}

TEST(Forest, OfALabelWithoutSamplesAreFinite) {
  LabelledSamples samples = two_clouds(20, 5);
  samples.classes = 3;
  EXPECT_TRUE(LinearDiscriminants(samples).beside(samples.features).allFinite());
}

TEST(Forest, OfAFeatureThatIsConstantAreFinite) {
  LabelledSamples samples = two_clouds(100, 6);
  samples.features.col(1).setConstant(0.3);
  EXPECT_TRUE(LinearDiscriminants(samples).beside(samples.features).allFinite());
}

TEST(ForestTree, PartsSamplesThatCanBeParted) {
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

TEST(ForestTree, KeepsItsLeavesLarge) {
  const LabelledSamples samples = two_clouds(500, 1);
  const Tree tree(samples, binned(samples.features), {2, 20}, RandomStream(2, 0, 0));
  for (int i = 0; i < 500; ++i) EXPECT_GE(tree.leaf_of(samples.features.row(i)).size(), 20U);
}

TEST(ForestTree, DrawsTwoThirdsOfTheSamples) {
  const LabelledSamples samples = two_clouds(3000, 1);
  const Tree tree(samples, binned(samples.features), {1, 50}, RandomStream(3, 0, 0));
  int drawn = 0;
  for (int i = 0; i < 3000; ++i) drawn += tree.drew(i);
  EXPECT_NEAR(drawn / 3000.0, 1 - std::exp(-1), 0.03);
}

TEST(ForestTree, HaveAboutAsManySamplesEach) {
  Eigen::MatrixXd samples(6400, 1);
  for (int i = 0; i < 6400; ++i) samples(i, 0) = i * i;
  const BinnedFeatures features = binned(samples);
  ASSERT_EQ(features.edges[0].size(), 63U);
  for (std::uint8_t b = 0; b < 64; ++b)
    EXPECT_NEAR(static_cast<double>(std::ranges::count(features.bin[0], b)), 100, 1);
}

TEST(ForestTree, OfFewValuesHaveABinForEach) {
  Eigen::MatrixXd samples(90, 1);
  for (int i = 0; i < 90; ++i) samples(i, 0) = i % 3;
  const BinnedFeatures features = binned(samples);
  EXPECT_EQ(features.edges[0], (std::vector<double>{0, 1}));
  for (std::size_t i = 0; i < 90; ++i) EXPECT_EQ(features.bin[0][i], i % 3);
}

TEST(ForestTree, OfOneValueHaveNoEdge) { EXPECT_TRUE(binned(Eigen::MatrixXd::Ones(10, 1)).edges[0].empty()); }

}  // namespace
}  // namespace rubsweep::diagnose::forest
