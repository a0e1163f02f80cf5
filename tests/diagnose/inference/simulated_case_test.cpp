#include "rubsweep/diagnose/inference/simulated_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(SimulatedCase, GrowsWithItsClearance) {
  // The same machine with a clearance ten times as large moves ten times as far, and pushes ten times as
  // hard.
  DiagnosisProblem problem = small_problem(), larger = problem;
  for (Candidate& candidate : larger.candidates) candidate.clearance_m = {5e-4, 1e-2, true};
  response::spectrum::SpectrumWorkspace workspace;
  int compared = 0;
  for (const SimulatedCase& one : small_set().cases) {
    // Motions that go on for ever from rounding are left out: those of chaos.
    if (one.candidate != 1 || one.motion.contact.hits > 40) continue;
    const auto other = simulate_case(larger, 1, one.unit, workspace);
    ASSERT_TRUE(other);
    ++compared;
    const double scale = size_of(other->motion.lines) / size_of(one.motion.lines);
    EXPECT_NEAR(scale, 10, 0.1);
    EXPECT_NEAR(other->motion.contact.peak_contact_force_n / one.motion.contact.peak_contact_force_n, scale,
                0.1);
    if (compared == 5) break;
  }
  EXPECT_EQ(compared, 5);
}

TEST(SimulatedCase, IsObservedTheSameEveryTime) {
  response::spectrum::SpectrumWorkspace workspace;
  const auto once = observe(small_problem(), small_set().cases[3], 3, workspace),
             again = observe(small_problem(), small_set().cases[3], 3, workspace),
             other = observe(small_problem(), small_set().cases[3], 4, workspace);
  EXPECT_EQ(features::values_of(once.seen.features), features::values_of(again.seen.features));
  EXPECT_NE(features::values_of(once.seen.features), features::values_of(other.seen.features));
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
