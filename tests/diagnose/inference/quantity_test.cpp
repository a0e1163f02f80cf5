#include "rubsweep/diagnose/inference/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(Quantity, QuantilesAreThoseOfTheWeights) {
  const Eigen::Vector4d values(1, 2, 3, 4), weight(0.1, 0.4, 0.4, 0.1);
  EXPECT_EQ(weighted_quantile(values, weight, 0.05, false), 1);
  EXPECT_EQ(weighted_quantile(values, weight, 0.5, false), 2);
  EXPECT_EQ(weighted_quantile(values, weight, 0.95, false), 4);
  EXPECT_NEAR(share_below(values, weight, 3, false), 0.7, 1e-12);
  EXPECT_NEAR(share_below(values, weight, 2.5, false), 0.5, 1e-12);
}

TEST(Quantity, AnglesGoRound) {
  const Eigen::Vector3d values(170, 179, -175), weight(1, 1, 1);
  EXPECT_NEAR(weighted_quantile(values, weight, 0.5, true), 179, 1e-9);
  EXPECT_NEAR(weighted_quantile(values, weight, 1, true), -175, 1e-9);
  EXPECT_NEAR(share_below(values, weight, -178, true), 2.0 / 3, 1e-12);
}

TEST(Quantity, OfACaseThatIsTheRecordingIsItsOwn) {
  const DiagnosisProblem problem = small_problem();
  ObservedCases observed;
  observe_cases(problem, small_set(), 0, observed);
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

}  // namespace
}  // namespace rubsweep::diagnose::inference
