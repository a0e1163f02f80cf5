#include "rubsweep/diagnose/forest/forest.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace rubsweep::diagnose::forest
