#include "rubsweep/diagnose/inference/marginal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rubsweep::diagnose::inference {
namespace {

/// 0, 0.001, ... 1, evenly likely in the prior.
Eigen::VectorXd even_values() { return Eigen::VectorXd::LinSpaced(1001, 0, 1); }
Eigen::VectorXd even_prior() { return Eigen::VectorXd::Ones(1001); }

TEST(Marginal, EqualCasesStandAtWeibullsPlottingPositions) {
  const Eigen::Vector4d values(4, 1, 3, 2), same = Eigen::Vector4d::Ones();
  const Marginal marginal(values, same, same, false);
  for (int k = 1; k <= 4; ++k) {
    EXPECT_NEAR(marginal.quantile(k / 5.0), k, 1e-12);
    EXPECT_NEAR(marginal.share_below(k), k / 5.0, 1e-12);
  }
  EXPECT_NEAR(marginal.quantile(0.5), 2.5, 1e-12);
  EXPECT_EQ(marginal.share_below(0.9), 0);
  EXPECT_EQ(marginal.share_below(4.1), 1);
}

TEST(Marginal, ReachesTowardsThePriorWhereFewCasesCount) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(1001);
  weight(800) = 1;
  const Marginal marginal(even_values(), weight, even_prior(), false);
  EXPECT_NEAR(marginal.quantile(0.5), 0.8, 1e-9);
  EXPECT_NEAR(marginal.quantile(0.25), 0.4, 1e-3);
  EXPECT_NEAR(marginal.quantile(0.75), 0.9, 1e-3);
  for (const double share : {0.025, 0.3, 0.6, 0.975})
    EXPECT_NEAR(marginal.share_below(marginal.quantile(share)), share, 1e-9);
}

TEST(Marginal, OfManyCasesIsTheirWeightedDistribution) {
  Eigen::VectorXd weight = even_values();
  const Marginal marginal(even_values(), weight, even_prior(), false);
  for (const double share : {0.025, 0.25, 0.5, 0.975})
    EXPECT_NEAR(marginal.quantile(share), std::sqrt(share), 2e-3);
}

TEST(Marginal, CountsEqualValuesHalf) {
  const Eigen::Vector4d values(1, 2, 2, 3), same = Eigen::Vector4d::Ones();
  const Marginal marginal(values, same, same, false);
  EXPECT_NEAR(marginal.share_below(2), 0.5, 1e-12);
  EXPECT_NEAR(marginal.share_below(2 - 1e-9), 0.4, 1e-6);
  EXPECT_NEAR(marginal.share_below(2 + 1e-9), 0.6, 1e-6);
}

TEST(Marginal, AnglesGoRound) {
  const Eigen::Vector3d values(170, 179, -175), same = Eigen::Vector3d::Ones();
  const Marginal marginal(values, same, same, true);
  EXPECT_NEAR(marginal.quantile(0.5), 179, 1e-9);
  EXPECT_NEAR(marginal.quantile(0.75), -175, 1e-9);
  EXPECT_NEAR(marginal.share_below(-178), 0.625, 1e-9);
}

struct Calibration {
  double inside = 0, below_middle = 0;  ///< shares of the true values
};

/// Simulation-based calibration where the posterior is known: a dozen draws of it, each with a weight of its
/// own, and the true value is one more draw.
template <class Posterior>
Calibration calibration_of(Posterior draw) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> weights(0.5, 1.5);
  constexpr int trials = 4000, draws = 12;
  Calibration found;
  for (int trial = 0; trial < trials; ++trial) {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(1001);
    for (int k = 0; k < draws; ++k) weight(static_cast<int>(1000 * draw(random))) += weights(random);
    const double place = Marginal(even_values(), weight, even_prior(), false).share_below(draw(random));
    found.inside += place > 0.025 && place < 0.975 ? 1.0 / trials : 0;
    found.below_middle += place < 0.5 ? 1.0 / trials : 0;
  }
  return found;
}

constexpr double four_deviations_at_95 = 0.014, four_deviations_at_50 = 0.032;

TEST(Marginal, HoldsTheTrueValueAsOftenAsItSaysWhereNothingWasLearnt) {
  const Calibration found =
      calibration_of([](auto& random) { return std::uniform_real_distribution<double>(0, 1)(random); });
  EXPECT_NEAR(found.inside, 0.95, four_deviations_at_95);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(Marginal, IsTooWideForAPosteriorMuchNarrowerThanThePrior) {
  const Calibration found =
      calibration_of([](auto& random) { return std::normal_distribution<double>(0.4, 0.08)(random); });
  EXPECT_GT(found.inside, 0.95);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(Marginal, EffectiveCasesAreThoseOfEqualWeight) {
  EXPECT_NEAR(effective_cases(Eigen::VectorXd::Constant(7, 0.2)), 7, 1e-12);
  EXPECT_NEAR(effective_cases(Eigen::Vector3d(1, 0, 0)), 1, 1e-12);
  EXPECT_EQ(effective_cases(Eigen::VectorXd::Zero(3)), 0);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
