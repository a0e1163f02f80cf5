#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <initializer_list>
#include <random>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Values 0, 0.001, ... 1 with equal prior probabilities.
Eigen::VectorXd even_values() { return Eigen::VectorXd::LinSpaced(1001, 0, 1); }
Eigen::VectorXd even_prior() { return Eigen::VectorXd::Ones(1001); }

double share_below(const Marginal& marginal, double value) {
  return (marginal.probability_below(value) + marginal.probability_up_to(value)) / 2;
}

Eigen::VectorXd weights_at(std::initializer_list<int> cases) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(1001);
  for (const int i : cases) weight(i) += 1;
  return weight;
}

TEST(CandidateMarginalsMarginal, EqualCasesStandAtWeibullsPlottingPositions) {
  const Marginal marginal(even_values(), weights_at({100, 300, 350, 700}), even_prior(), false);
  EXPECT_EQ(marginal.quantile(0.2), even_values()(100));
  EXPECT_EQ(marginal.quantile(0.4), even_values()(300));
  EXPECT_EQ(marginal.quantile(0.6), even_values()(350));
  EXPECT_EQ(marginal.quantile(0.8), even_values()(700));
  EXPECT_NEAR(share_below(marginal, 0.2), 0.3, 1e-3);
  EXPECT_EQ(share_below(marginal, -0.1), 0);
  EXPECT_EQ(share_below(marginal, 1.1), 1);
}

TEST(CandidateMarginalsMarginal, ReachesTowardsThePriorWhereFewCasesCount) {
  const Marginal marginal(even_values(), weights_at({800}), even_prior(), false);
  EXPECT_NEAR(marginal.quantile(0.5), 0.8, 1e-9);
  EXPECT_NEAR(marginal.quantile(0.25), 0.4, 2e-3);
  EXPECT_NEAR(marginal.quantile(0.75), 0.9, 2e-3);
  for (const double share : {0.025, 0.3, 0.6, 0.975})
    EXPECT_NEAR(share_below(marginal, marginal.quantile(share)), share, 3e-3);
}

TEST(CandidateMarginalsMarginal, OfManyCasesIsTheirWeightedDistribution) {
  const Marginal marginal(even_values(), even_values(), even_prior(), false);
  for (const double share : {0.025, 0.25, 0.5, 0.975})
    EXPECT_NEAR(marginal.quantile(share), std::sqrt(share), 4e-3);
}

TEST(CandidateMarginalsMarginal, DoesNotFeelCasesOfHardlyAnyWeight) {
  Eigen::VectorXd weight = weights_at({300, 400, 500, 600});
  const Marginal four(even_values(), weight, even_prior(), false);
  weight(10) = weight(990) = 1e-12;
  const Marginal six(even_values(), weight, even_prior(), false);
  for (const double share : {0.025, 0.25, 0.5, 0.75, 0.975})
    EXPECT_EQ(six.quantile(share), four.quantile(share));
}

TEST(CandidateMarginalsMarginal, DoesNotDependOnTheOrderOfEqualValues) {
  Eigen::VectorXd values(6), weight(6), other_way(6);
  values << 1, 2, 5, 5, 5, 5;
  weight << 0, 1, 1, 0, 0, 0;
  other_way << 0, 1, 0, 0, 0, 1;
  const Eigen::VectorXd prior = Eigen::VectorXd::Ones(6);
  const Marginal one(values, weight, prior, false), other(values, other_way, prior, false);
  EXPECT_EQ(share_below(one, 5), share_below(other, 5));
  EXPECT_EQ(share_below(one, 4.9), share_below(other, 4.9));
  EXPECT_EQ(share_below(one, 5.1), 1);
  const Marginal all_equal(Eigen::Vector2d(5, 5), Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), false);
  EXPECT_EQ(share_below(all_equal, 5), 0.5);
  EXPECT_EQ(all_equal.quantile(0.025), 5);
}

TEST(CandidateMarginalsMarginal, AnglesGoRound) {
  const Eigen::VectorXd angles = 360 * even_values();
  const Marginal marginal(angles, weights_at({470, 500, 515}), even_prior(), true);
  EXPECT_NEAR(marginal.quantile(0.25), 169.2, 1e-9);
  EXPECT_NEAR(marginal.quantile(0.5), 180, 1e-9);
  EXPECT_NEAR(marginal.quantile(0.75), 185.4 - 360, 1e-9);
  EXPECT_NEAR(share_below(marginal, -178), 0.5 + 0.25 * 2 / 5.4, 0.03);
}

struct Calibration {
  /// shares of trials whose true value is inside the interval, or below its middle
  double inside = 0, below_middle = 0;
};

/// Simulation-based calibration with a known posterior: weighted draws from it, and one more draw as the true
/// value. `spread`: standard deviation of the logarithms of the weights.
template <class Posterior>
Calibration calibration_of(Posterior draw, int draws, double spread) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int trials = 4000;
  Calibration found;
  for (int trial = 0; trial < trials; ++trial) {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(1001);
    for (int k = 0; k < draws; ++k)
      weight(static_cast<int>(1000 * draw(random))) += std::exp(spread * normal(random));
    const double place = share_below(Marginal(even_values(), weight, even_prior(), false), draw(random));
    found.inside += place > 0.025 && place < 0.975 ? 1.0 / trials : 0;
    found.below_middle += place < 0.5 ? 1.0 / trials : 0;
  }
  return found;
}

constexpr double four_deviations_at_95 = 0.014, four_deviations_at_50 = 0.032;

double anywhere(std::mt19937_64& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

double near_one_value(std::mt19937_64& random) {
  return std::clamp(std::normal_distribution<double>(0.4, 0.08)(random), 0.0, 1.0);
}

TEST(CandidateMarginalsMarginal, HoldsTheTrueValueAsOftenAsItSaysWhereNothingWasLearnt) {
  const Calibration found = calibration_of(anywhere, 12, 0.3);
  EXPECT_NEAR(found.inside, 0.95, four_deviations_at_95);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(CandidateMarginalsMarginal, HoldsTheTrueValueAsOftenAsItSaysWhereManyCasesCount) {
  const Calibration found = calibration_of(near_one_value, 150, 0.3);
  EXPECT_NEAR(found.inside, 0.95, four_deviations_at_95);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(CandidateMarginalsMarginal, IsNotTooNarrowWhereFewCasesHaveMostOfTheWeight) {
  const Calibration found = calibration_of(anywhere, 200, 2);
  EXPECT_GT(found.inside, 0.95 - four_deviations_at_95);
  EXPECT_LT(found.inside, 0.98);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(CandidateMarginalsMarginal, IsTooWideWhereFewCasesTellMuch) {
  const Calibration found = calibration_of(near_one_value, 12, 0.3);
  EXPECT_GT(found.inside, 0.95);
  EXPECT_NEAR(found.below_middle, 0.5, four_deviations_at_50);
}

TEST(CandidateMarginalsMarginal, TheBetaTransformMovesProbabilitiesAndKeepsTheMedian) {
  const Marginal even(even_values(), even_prior(), even_prior(), false);
  EXPECT_EQ(even.beta_transformed(1).quantile(0.3), even.quantile(0.3));
  const Marginal narrow = even.beta_transformed(2);
  EXPECT_NEAR(narrow.quantile(0.5), 0.5, 2e-3);
  // For the parameter 2 the distribution function is 3 u^2 - 2 u^3.
  EXPECT_NEAR(narrow.probability_up_to(0.2), 3 * 0.04 - 2 * 0.008, 2e-3);
  EXPECT_NEAR(narrow.quantile(3 * 0.04 - 2 * 0.008), 0.2, 3e-3);
}

TEST(CandidateMarginalsMarginal, EffectiveCasesAreThoseOfEqualWeight) {
  EXPECT_NEAR(effective_cases(Eigen::VectorXd::Constant(7, 0.2)), 7, 1e-12);
  EXPECT_NEAR(effective_cases(Eigen::Vector3d(1, 0, 0)), 1, 1e-12);
  EXPECT_NEAR(effective_cases(Eigen::VectorXd::Constant(7, 1e-170)), 7, 1e-12);
  EXPECT_EQ(effective_cases(Eigen::VectorXd::Zero(3)), 0);
}

/// Evenly spaced quantiles of the symmetric beta distribution with parameter `beta`.
Eigen::VectorXd ranks_with(double beta, int count) {
  Eigen::VectorXd ranks(count);
  for (int k = 0; k < count; ++k) ranks(k) = boost::math::ibeta_inv(beta, beta, (k + 0.5) / count);
  return ranks;
}

TEST(CandidateMarginals, FindTheBetaDistributionOfManyRanks) {
  const Eigen::VectorXd same = Eigen::VectorXd::Ones(5000);
  for (const double beta : {0.6, 1.0, 1.3, 2.0})
    EXPECT_NEAR(beta_of_ranks(ranks_with(beta, 5000), same), beta, 0.01 * beta);
}

TEST(CandidateMarginals, FewRanksHardlyMoveIt) {
  EXPECT_EQ(beta_of_ranks(Eigen::VectorXd::Constant(3, 0.5), Eigen::VectorXd::Zero(3)), 1);
  const double of_one = beta_of_ranks(Eigen::VectorXd::Constant(1, 0.5), Eigen::VectorXd::Ones(1));
  EXPECT_GT(of_one, 1);
  EXPECT_LT(of_one, 1.05);
}

TEST(CandidateMarginals, CountRanksByTheirWeights) {
  Eigen::VectorXd ranks(4000), weight(4000);
  ranks << ranks_with(2, 2000), ranks_with(0.6, 2000);
  weight << Eigen::VectorXd::Ones(2000), Eigen::VectorXd::Constant(2000, 1e-6);
  EXPECT_NEAR(beta_of_ranks(ranks, weight), 2, 0.03);
}

/// Marginals for the candidate with a stop, from a recording of a case outside the set.
std::vector<QuantityMarginal> marginals_of_a_stop(std::uint64_t seed, int threads = 0) {
  const ObservedCases observed = observed_cases(small_problem(), small_set(), 0);
  const features::DescribedMotion seen = recorded_case(1, seed);
  const Posterior posterior = posterior_of(small_problem(), small_set(), observed, seen, 0);
  return marginals_of(small_problem(), small_set(), observed, posterior, seen, 1, threads);
}

TEST(CandidateMarginals, AreThoseOfTheQuantitiesThatACandidateHas) {
  const auto marginals = marginals_of_a_stop(41);
  EXPECT_EQ(marginals.size(), all_quantities.size() - 2);
  for (const auto& [quantity, marginal] : marginals) {
    EXPECT_NE(quantity, Quantity::position);
    EXPECT_NE(quantity, Quantity::exponent);
    EXPECT_TRUE(std::isfinite(marginal.quantile(0.025))) << to_string(quantity);
    EXPECT_GE(marginal.probability_up_to(marginal.quantile(0.5)), 0.5) << to_string(quantity);
    EXPECT_LE(marginal.probability_below(marginal.quantile(0.5)), 0.5) << to_string(quantity);
  }
  const ObservedCases observed = observed_cases(small_problem(), small_set(), 0);
  const features::DescribedMotion seen = recorded_case(0, 41);
  const Posterior posterior = posterior_of(small_problem(), small_set(), observed, seen, 0);
  EXPECT_TRUE(marginals_of(small_problem(), small_set(), observed, posterior, seen, 0, 0).empty());
}

TEST(CandidateMarginals, DoNotDependOnThreads) {
  const auto one = marginals_of_a_stop(42, 1), three = marginals_of_a_stop(42, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k)
    for (const double share : {0.025, 0.5, 0.975})
      EXPECT_EQ(one[k].marginal.quantile(share), three[k].marginal.quantile(share));
}

/// The beta transform keeps the median. A difference of any other probability from the plain marginal shows
/// that it was applied, and gives its parameter.
TEST(CandidateMarginals, AreTransformedByTheRanksOfSimilarCases) {
  const DiagnosisProblem problem = small_problem();
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  const features::DescribedMotion seen = recorded_case(1, 43);
  const Posterior posterior = posterior_of(problem, small_set(), observed, seen, 0);
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < small_set().cases.size(); ++i)
    if (small_set().cases[i].candidate == 1) rows.push_back(static_cast<Eigen::Index>(i));
  const Eigen::VectorXd weight = posterior.weight(rows), prior = posterior.size_density(rows);
  int moved = 0;
  for (const auto& [quantity, marginal] :
       marginals_of(problem, small_set(), observed, posterior, seen, 1, 0)) {
    const Eigen::VectorXd values = values_in_cases(problem, small_set(), observed, seen, quantity)(rows);
    const Marginal plain(values, weight, prior, quantity == Quantity::stop_angle);
    const double lower = plain.quantile(0.25);
    if (std::abs(plain.probability_up_to(lower) - marginal.probability_up_to(lower)) > 1e-3) ++moved;
    EXPECT_EQ(plain.quantile(0), marginal.quantile(0)) << to_string(quantity);
    // The parameter is within three deviations of its prior, exp(0.75) = 2.1, which limits the difference.
    EXPECT_NEAR(plain.probability_up_to(lower), marginal.probability_up_to(lower), 0.2)
        << to_string(quantity);
  }
  EXPECT_GT(moved, 4);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
