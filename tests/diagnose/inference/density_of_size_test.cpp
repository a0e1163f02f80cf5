#include "rubsweep/diagnose/inference/density_of_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

constexpr double case_size_m = 1e-4;

/// Density of a case of the candidate whose clearance would have to be this one. Its numbers stand in the
/// middle of their ranges.
double density_at(const DiagnosisProblem& problem, std::size_t candidate, double clearance,
                  double eccentricity_m = 0) {
  SimulatedCase one{.candidate = candidate};
  one.unit.fill(0.5);
  one.motion.eccentricity_m = eccentricity_m;
  const double seen_size_m = case_size_m * clearance / simulated_clearance_m(problem.candidates[candidate]);
  return density_of_size(problem, one, case_size_m, seen_size_m);
}

TEST(DensityOfSize, OfARubIsThatOfItsClearances) {
  const DiagnosisProblem problem = small_problem();  // 50 um to 1 mm
  EXPECT_EQ(density_at(problem, 1, 6e-5), 1);
  EXPECT_EQ(density_at(problem, 1, 9e-4), 1);
  EXPECT_EQ(density_at(problem, 1, 4e-5), 0);
  EXPECT_EQ(density_at(problem, 1, 1.1e-3), 0);
}

TEST(DensityOfSize, OfAQuietWhirlIsTheShareOfWhirlRatiosThatTheSizeAllows) {
  const DiagnosisProblem problem = small_problem();
  const Candidate& quiet = problem.candidates[0];
  const Spread ratios = spread_of(quiet, Unknown::whirl_ratio);
  const double middle = std::sqrt(ratios.low * ratios.high);
  // A radius of 0.2 mm: from 0.2 of the largest clearance to all of one that is as large.
  const double radius_m = 2e-4;
  EXPECT_NEAR(density_at(problem, 0, radius_m / middle),
              std::log(ratios.high / 0.2) / std::log(ratios.high / ratios.low), 1e-9);
  EXPECT_EQ(density_at(problem, 0, 1.1e-3 * ratios.high / middle), 0);
}

TEST(DensityOfSize, OfAKnownUnbalanceIsHigherTheNarrowerItIs) {
  DiagnosisProblem problem = small_problem();
  const double eccentricity_m = 1e-5, clearance = simulated_clearance_m(problem.candidates[1]);
  problem.eccentricity_m = {eccentricity_m / 2, eccentricity_m * 2, true};
  EXPECT_NEAR(density_at(problem, 1, clearance, eccentricity_m), std::log(20) / std::log(4), 1e-9);
  EXPECT_EQ(density_at(problem, 1, clearance, 3 * eccentricity_m), 0);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
