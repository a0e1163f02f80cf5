#include "rubsweep/measurement/diagnose/inference/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(Quantity, OfACaseThatIsTheRecordingIsItsOwn) {
  const DiagnosisProblem problem = small_problem();
  const ObservedCases observed = observed_cases(problem, small_set(), 0);
  std::size_t i = 0;
  while (small_set().cases[i].candidate != 1) ++i;
  response::spectrum::SpectrumWorkspace workspace;
  const features::DescribedMotion seen = observe(problem, small_set().cases[i], i, workspace).seen;
  const auto own = [&](Quantity quantity) {
    return values_in_cases(problem, small_set(), observed, seen, quantity)(static_cast<Eigen::Index>(i));
  };
  EXPECT_NEAR(own(Quantity::clearance), simulated_clearance_m(problem.candidates[1]), 1e-15);
  EXPECT_NEAR(own(Quantity::stop_angle), 0, 1e-9);
  EXPECT_EQ(own(Quantity::contact_fraction), small_set().cases[i].motion.contact.contact_fraction);
  EXPECT_NEAR(own(Quantity::eccentricity), small_set().cases[i].motion.eccentricity_m, 1e-15);
  for (const Quantity quantity : all_quantities)
    EXPECT_TRUE(std::isfinite(own(quantity))) << to_string(quantity);
}

TEST(Quantity, AnExponentIsOneWhereItIsNotKnown) {
  DiagnosisProblem problem = small_problem();
  EXPECT_FALSE(has_quantity(problem, 1, Quantity::exponent));
  spread_of(problem.candidates[1], Unknown::exponent) = {1, 2, false};
  EXPECT_TRUE(has_quantity(problem, 1, Quantity::exponent));
  EXPECT_FALSE(has_quantity(problem, 0, Quantity::exponent));
  CaseSet set = small_set();
  const ObservedCases observed = observed_cases(problem, set, 0);
  for (SimulatedCase& one : set.cases) one.unit[static_cast<std::size_t>(Unknown::exponent)] = 0.5;
  const auto last = static_cast<Eigen::Index>(set.cases.size()) - 1;
  EXPECT_EQ(values_in_cases(problem, set, observed, recorded_case(1, 11), Quantity::exponent)(last), 1.5);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
