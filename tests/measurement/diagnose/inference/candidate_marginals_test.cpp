#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>
#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// Ranks that a beta distribution with both parameters `beta` has, evenly.
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

/// Marginals of the stop, from a recording of a case that the set does not hold.
std::vector<QuantityMarginal> marginals_of_a_stop(std::uint64_t seed, int threads = 0) {
  ObservedCases observed;
  observe_cases(small_problem(), small_set(), 0, observed);
  const features::DescribedMotion seen = recorded_case(1, seed);
  const Posterior posterior = posterior_of(small_problem(), small_set(), observed, seen, 0);
  return marginals_of(small_problem(), small_set(), observed, posterior, seen, 1, threads);
}

TEST(CandidateMarginals, AreThoseOfTheQuantitiesThatACandidateHas) {
  const auto marginals = marginals_of_a_stop(41);
  EXPECT_EQ(marginals.size(), all_quantities.size() - 1);
  for (const auto& [quantity, marginal] : marginals) {
    EXPECT_NE(quantity, Quantity::position);
    EXPECT_TRUE(std::isfinite(marginal.quantile(0.025))) << to_string(quantity);
    EXPECT_GE(marginal.probability_up_to(marginal.quantile(0.5)), 0.5) << to_string(quantity);
    EXPECT_LE(marginal.probability_below(marginal.quantile(0.5)), 0.5) << to_string(quantity);
  }
  ObservedCases observed;
  observe_cases(small_problem(), small_set(), 0, observed);
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

/// The beta transform keeps the median. Any other probability that differs from that of the plain marginal
/// shows that it was applied, and gives its parameter.
TEST(CandidateMarginals, AreTransformedByTheRanksOfSimilarCases) {
  const DiagnosisProblem problem = small_problem();
  ObservedCases observed;
  observe_cases(problem, small_set(), 0, observed);
  const features::DescribedMotion seen = recorded_case(1, 43);
  const Posterior posterior = posterior_of(problem, small_set(), observed, seen, 0);
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < small_set().cases.size(); ++i)
    if (small_set().cases[i].candidate == 1) rows.push_back(static_cast<Eigen::Index>(i));
  const Eigen::VectorXd weight = posterior.weight(rows),
                        prior = posterior.importance(rows).cwiseProduct(posterior.size_density(rows));
  int moved = 0;
  for (const auto& [quantity, marginal] :
       marginals_of(problem, small_set(), observed, posterior, seen, 1, 0)) {
    const Eigen::VectorXd values = values_in_cases(problem, small_set(), observed, seen, quantity)(rows);
    const Marginal plain(values, weight, prior, quantity == Quantity::stop_angle);
    const double lower = plain.quantile(0.25);
    if (std::abs(plain.probability_up_to(lower) - marginal.probability_up_to(lower)) > 1e-3) ++moved;
    EXPECT_EQ(plain.quantile(0), marginal.quantile(0)) << to_string(quantity);
    // A parameter is within three deviations of its prior, exp(0.75) = 2.1, and the rank beside it.
    EXPECT_NEAR(plain.probability_up_to(lower), marginal.probability_up_to(lower), 0.2)
        << to_string(quantity);
  }
  EXPECT_GT(moved, 4);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
