#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

Posterior posterior_of_case(std::size_t candidate, const DiagnosisProblem& problem, int threads = 0) {
  const ObservedCases observed = observed_cases(problem, small_set(), threads);
  return posterior_of(problem, small_set(), observed, recorded_case(candidate, 11), threads);
}

TEST(Posterior, KnowsASubharmonicRubFromNone) {
  const Posterior rub = posterior_of_case(1, small_problem()), none = posterior_of_case(0, small_problem());
  EXPECT_GT(rub.probability(1), 0.8);
  EXPECT_GT(none.probability(0), 0.8);
  for (const Posterior& posterior : {rub, none}) {
    EXPECT_NEAR(posterior.probability.sum(), 1, 1e-12);
    EXPECT_LT(posterior.none, 0.5);
    double of_second = 0;
    for (std::size_t i = 0; i < small_set().cases.size(); ++i)
      if (small_set().cases[i].candidate == 1) of_second += posterior.weight(static_cast<Eigen::Index>(i));
    EXPECT_NEAR(of_second, posterior.probability(1), 0.01);
  }
}

/// Bayes' theorem: odds of two candidates are multiplied by their prior odds.
TEST(Posterior, OddsAreThoseOfEqualPriorsTimesThePriorOdds) {
  DiagnosisProblem problem = small_problem();
  for (const std::size_t candidate : {0U, 1U}) {
    problem.prior = {0.5, 0.5};
    const Posterior equal = posterior_of_case(candidate, problem);
    problem.prior = {0.2, 0.8};
    const Posterior likelier = posterior_of_case(candidate, problem);
    const auto odds = [](const Posterior& p) { return p.probability(1) / p.probability(0); };
    EXPECT_NEAR(odds(likelier) / odds(equal), 4, 1e-9);
    const auto of_none = [](const Posterior& p) { return p.none / ((1 - p.none) * p.probability(0)); };
    EXPECT_NEAR(of_none(likelier) / of_none(equal), 2.5, 1e-9);
  }
}

/// Likelihood ratios, odds over prior odds, are raised to the power.
TEST(Posterior, WeakEvidenceLeavesMoreOfThePriors) {
  DiagnosisProblem problem = small_problem();
  problem.prior = {0.8, 0.2};
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  const auto answer = [&](double power) {
    return posterior_of(problem, small_set(), observed, recorded_case(1, 11), 0, power);
  };
  const Posterior full = answer(1), half = answer(0.5);
  const auto ratio = [](const Posterior& p) { return p.probability(1) / p.probability(0) * 4; };
  EXPECT_GT(ratio(full), 20);
  EXPECT_NEAR(ratio(half) / std::sqrt(ratio(full)), 1, 1e-9);
  const auto of_none = [](const Posterior& p) { return 4 * p.none / ((1 - p.none) * p.probability(0)); };
  EXPECT_NEAR(of_none(half) / std::sqrt(of_none(full)), 1, 1e-9);
}

TEST(Posterior, EvidenceOfARecordingThatResemblesNoCaseIsWeak) {
  EXPECT_EQ(evidence_power_of(1), 1);
  EXPECT_EQ(evidence_power_of(0.2), 1);
  EXPECT_DOUBLE_EQ(evidence_power_of(0.1), 0.75);
  EXPECT_EQ(evidence_power_of(0), 0.5);
}

TEST(PosteriorPValue, FindsNothingStrangeInACase) {
  const ObservedCases observed = observed_cases(small_problem(), small_set(), 0);
  for (const std::size_t candidate : {0U, 1U})
    EXPECT_GT(p_value_of(observed, recorded_case(candidate, 11), 0), 0.01);
}

TEST(Posterior, ExcludesClearancesThatTheCandidateDoesNotHave) {
  DiagnosisProblem problem = small_problem();
  const double middle_m = simulated_clearance_m(problem.candidates[1]);
  problem.candidates[1].clearance_m = {middle_m / 1.5, middle_m * 1.5, true};
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  // A motion a hundred times larger requires a clearance a hundred times larger.
  features::DescribedMotion seen = recorded_case(1, 11);
  EXPECT_GT(posterior_of(problem, small_set(), observed, seen, 0).probability(1), 0.8);
  seen.size_m *= 100;
  EXPECT_GT(posterior_of(problem, small_set(), observed, seen, 0).none, 0.9);
}

TEST(Posterior, AQuietWhirlAsLargeAsManyClearancesIsNone) {
  DiagnosisProblem problem = small_problem();
  problem.candidates[0].clearance_m = {1e-4, 2e-4, true};
  // With few cases a quiet whirl is hard to distinguish from similar vibrations of other causes.
  const CaseSet set = prior_cases(problem, {.cases_per_candidate = 400});
  const ObservedCases observed = observed_cases(problem, set, 0);
  features::DescribedMotion seen = recorded_case(0, 11);
  const auto no_rub_at = [&](double size_m) {
    seen.size_m = size_m;
    const Posterior posterior = posterior_of(problem, set, observed, seen, 0);
    return (1 - posterior.none) * posterior.probability(0);
  };
  // Whirl ratios are from 0.01 to 1, clearances from 100 to 200 um.
  EXPECT_GT(no_rub_at(1e-5), 0.8);
  EXPECT_LT(no_rub_at(4e-4), 0.1);
  EXPECT_LT(no_rub_at(4e-7), 0.1);
}

TEST(Posterior, AKnownUnbalanceTellsWhetherItExplainsTheSize) {
  DiagnosisProblem problem = small_problem();
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  const features::DescribedMotion quiet = recorded_case(0, 11);
  EXPECT_GT(posterior_of(problem, small_set(), observed, quiet, 0).probability(0), 0.8);
  // At r = 2.2 a Jeffcott rotor whirls with the radius e r^2 / (r^2 - 1), which is the root mean square of a
  // circle.
  const double r = 66 / 30.15, eccentricity_m = quiet.size_m * (r * r - 1) / (r * r);
  problem.eccentricity_m = {eccentricity_m / 1.2, eccentricity_m * 1.2, true};
  EXPECT_GT(posterior_of(problem, small_set(), observed, quiet, 0).probability(0), 0.8);
  // An unbalance three times larger would cause a larger circle.
  problem.eccentricity_m = {2.5 * eccentricity_m, 3.6 * eccentricity_m, true};
  for (const double evidence_power : {1.0, 0.5}) {
    const Posterior posterior = posterior_of(problem, small_set(), observed, quiet, 0, evidence_power);
    EXPECT_LT((1 - posterior.none) * posterior.probability(0), 0.1);
  }
}

TEST(Posterior, KnowsWhatIsNoneOfThem) {
  const DiagnosisProblem problem = small_problem();
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  // A strong line at 2X, and a backward line at 2.37X.
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 96 + 1)};
  lines.at(12) = 1e-4;
  lines.at(24) = 1e-4;
  lines.at(-28) = 4e-5;
  lines.at(-29) = 4e-5;
  response::spectrum::SpectrumWorkspace workspace;
  RandomStream random(8, 0, 0);
  double probe_angle_rad = 0;
  const MotionLines measured = diagnose::observed(lines, problem.measuring, random, probe_angle_rad);
  const features::DescribedMotion seen = features::describe(measured, {}, workspace);
  const double none = posterior_of(problem, small_set(), observed, seen, 0).none;
  EXPECT_GT(none, 0.5);
  // Weak evidence for the candidates is no evidence against none of them.
  EXPECT_EQ(posterior_of(problem, small_set(), observed, seen, 0, 0.5).none, none);
}

TEST(Posterior, OtherCausesHaveAnySizeUpToThreeClearances) {
  // With the same mean clearance the cases are those of the set, and each may be as large as the recordings
  // below.
  DiagnosisProblem problem = small_problem();
  for (Candidate& candidate : problem.candidates) candidate.clearance_m = {5e-6, 1e-2, true};
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  features::DescribedMotion seen = recorded_case(1, 11);
  // Share of none in the forest over that of one side: priors, power and the thousandth of a share are
  // undone.
  const auto share_of_none = [&](double size_m) {
    seen.size_m = size_m;
    const Posterior posterior = posterior_of(problem, small_set(), observed, seen, 0);
    const auto raised = [&](double p) { return std::pow(p, 1 / posterior.sharpness); };
    const double some = (1 - posterior.none) / (5.0 / 12), none = raised(posterior.none / (1.0 / 6)),
                 quiet = raised(some * posterior.probability(0)),
                 rub = raised(some * posterior.probability(1)), all = none + quiet + rub;
    return (none / all * 1.003 - 0.001) / (rub / all * 1.003 - 0.001);
  };
  // From 0.02 to 3 clearances at 200 um, from 0.04 on at 400 um.
  EXPECT_NEAR(share_of_none(4e-4) / share_of_none(2e-4), std::log(3 / 0.04) / std::log(3 / 0.02), 1e-6);
}

TEST(Posterior, DoesNotDependOnThreads) {
  EXPECT_EQ(posterior_of_case(1, small_problem(), 1).weight, posterior_of_case(1, small_problem(), 3).weight);
}

constexpr double case_size_m = 1e-4;

/// Size density of a case for the recording whose size requires `clearance`. The candidate's numbers are in
/// the middle of their ranges.
double density_at(const DiagnosisProblem& problem, std::size_t candidate, double clearance,
                  double eccentricity_m = 0) {
  SimulatedCase one{.candidate = candidate};
  one.unit.fill(0.5);
  one.motion.eccentricity_m = eccentricity_m;
  const double seen_size_m = case_size_m * clearance / simulated_clearance_m(problem.candidates[candidate]);
  return density_of_size(problem, one, case_size_m, seen_size_m);
}

TEST(Posterior, OfARubIsThatOfItsClearances) {
  const DiagnosisProblem problem = small_problem();  // clearances from 50 um to 1 mm
  EXPECT_EQ(density_at(problem, 1, 6e-5), 1);
  EXPECT_EQ(density_at(problem, 1, 9e-4), 1);
  EXPECT_EQ(density_at(problem, 1, 4e-5), 0);
  EXPECT_EQ(density_at(problem, 1, 1.1e-3), 0);
}

TEST(Posterior, OfAQuietWhirlIsTheShareOfWhirlRatiosThatTheSizeAllows) {
  const DiagnosisProblem problem = small_problem();
  const Candidate& quiet = problem.candidates[0];
  const Spread ratios = spread_of(quiet, Unknown::whirl_ratio);
  const double middle = std::sqrt(ratios.low * ratios.high);
  // A radius of 0.2 mm: whirl ratios from 0.2 (largest clearance) to 1 (clearance equal to the radius).
  const double radius_m = 2e-4;
  EXPECT_NEAR(density_at(problem, 0, radius_m / middle),
              std::log(ratios.high / 0.2) / std::log(ratios.high / ratios.low), 1e-9);
  EXPECT_EQ(density_at(problem, 0, 1.1e-3 * ratios.high / middle), 0);
}

TEST(Posterior, OfAKnownUnbalanceIsHigherTheNarrowerItIs) {
  DiagnosisProblem problem = small_problem();
  const double eccentricity_m = 1e-5, clearance = simulated_clearance_m(problem.candidates[1]);
  problem.eccentricity_m = {eccentricity_m / 2, eccentricity_m * 2, true};
  EXPECT_NEAR(density_at(problem, 1, clearance, eccentricity_m), std::log(20) / std::log(4), 1e-9);
  EXPECT_EQ(density_at(problem, 1, clearance, 3 * eccentricity_m), 0);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
