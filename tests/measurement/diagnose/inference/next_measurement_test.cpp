#include "rubsweep/measurement/diagnose/inference/next_measurement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// A diagnosis with equal probabilities, although the candidates differ.
Diagnosis undecided(const DiagnosisProblem& problem) {
  Diagnosis diagnosis;
  diagnosis.set = small_set();
  diagnosis.posterior.weight = prior_weights(problem, diagnosis.set);
  diagnosis.posterior.probability = Eigen::Vector2d(0.5, 0.5);
  return diagnosis;
}

TEST(NextMeasurement, TellsCandidatesApartThatDiffer) {
  const auto measurements = next_measurements(small_problem(), undecided(small_problem()), 0);
  ASSERT_EQ(measurements.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(measurements, std::greater{}, &NextMeasurement::information_bits));
  // Two candidates, a rub on one stop or none, allow one bit at most; the best measurement gives most of it.
  EXPECT_GT(measurements.front().information_bits, 0.5);
  EXPECT_LE(measurements.front().information_bits, 1);
}

TEST(NextMeasurement, OfOneProbeMayBeASecondOne) {
  DiagnosisProblem problem = small_problem();
  problem.measuring.probes = 1;
  const auto measurements = next_measurements(problem, undecided(problem), 0);
  EXPECT_TRUE(
      std::ranges::any_of(measurements, [](const auto& next) { return next.name == "a second probe"; }));
}

TEST(NextMeasurement, IsNotNeededWhereNothingIsOpen) {
  Diagnosis diagnosis = undecided(small_problem());
  diagnosis.posterior.probability = Eigen::Vector2d(0.001, 0.999);
  EXPECT_TRUE(next_measurements(small_problem(), diagnosis, 0).empty());
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
