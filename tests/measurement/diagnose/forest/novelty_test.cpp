#include "rubsweep/measurement/diagnose/forest/novelty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::forest {
namespace {

/// Draws a point from a dense or from a wide cloud.
Eigen::VectorXd draw(RandomStream& random) {
  const bool wide = random.uniform() < 0.5;
  Eigen::VectorXd x(4);
  for (double& value : x) value = (wide ? 6 : 0) + (wide ? 2 : 0.2) * random.normal();
  return x;
}

Eigen::MatrixXd population(int count) {
  RandomStream random(1, 0, 0);
  Eigen::MatrixXd cases(count, 4);
  for (int i = 0; i < count; ++i) cases.row(i) = draw(random).transpose();
  return cases;
}

TEST(Novelty, OfThePopulationIsEvenlyDistributed) {
  const Novelty novelty(population(800));
  RandomStream random(2, 0, 0);
  std::vector<double> p;
  for (int k = 0; k < 1000; ++k) p.push_back(novelty.p_value(draw(random)));
  std::ranges::sort(p);
  // Kolmogorov-Smirnov test at 0.1 %, widened by the scatter of the population's own quantiles.
  double largest = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    largest = std::max(largest, std::abs(p[k] - static_cast<double>(k + 1) / static_cast<double>(p.size())));
  EXPECT_LT(largest, 1.95 * std::sqrt(1.0 / 800 + 1.0 / 1000));
}

TEST(Novelty, FindsWhatStandsBesideADenseCloud) {
  const Novelty novelty(population(800));
  // This point is closer to the dense cloud than members of the wide cloud are to each other, but is still
  // novel.
  EXPECT_LT(novelty.p_value(Eigen::Vector4d(1.5, 0, 0, 0)), 0.01);
  EXPECT_GT(novelty.p_value(Eigen::Vector4d(0, 0.1, 0, 0)), 0.05);
}

TEST(Novelty, GivesTheSameWithAnyNumberOfThreads) {
  const Eigen::Vector4d here(1, 0, 0.5, 0);
  EXPECT_EQ(Novelty(population(100), 1).p_value(here), Novelty(population(100), 3).p_value(here));
}

}  // namespace
}  // namespace rubsweep::diagnose::forest
