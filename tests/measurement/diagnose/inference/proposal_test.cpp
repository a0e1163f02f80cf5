#include "rubsweep/measurement/diagnose/inference/proposal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::diagnose::inference {
namespace {

/// Only the whirl ratio and the kick's phase are unknown.
Candidate two_unknowns() {
  Candidate candidate = usual_candidate(Cause::one_side);
  for (Spread& spread : candidate.spreads) spread = {1, 1};
  spread_of(candidate, Unknown::whirl_ratio) = {0, 1};
  spread_of(candidate, Unknown::kick_phase) = {0, 1};
  return candidate;
}

Point at(double whirl, double phase) {
  Point unit{};
  unit[static_cast<std::size_t>(Unknown::whirl_ratio)] = whirl;
  unit[static_cast<std::size_t>(Unknown::kick_phase)] = phase;
  return unit;
}

Proposal proposal() { return {two_unknowns(), {at(0.05, 0.2), at(0.3, 0.9)}, {1, 3}}; }

TEST(Proposal, HasADensityThatAddsUpToOne) {
  double sum = 0;
  constexpr int n = 200;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) sum += proposal().density(at((i + 0.5) / n, (j + 0.5) / n)) / (n * n);
  EXPECT_NEAR(sum, 1, 2e-3);
}

TEST(Proposal, DrawsFromItsDensity) {
  RandomStream random(1, 0, 0);
  constexpr int count = 20'000;
  int low = 0;
  for (int k = 0; k < count; ++k) {
    const Point unit = proposal().draw(random);
    for (const double place : unit) {
      ASSERT_GE(place, 0);
      ASSERT_LE(place, 1);
    }
    low += unit[static_cast<std::size_t>(Unknown::whirl_ratio)] < 0.2 ? 1 : 0;
  }
  double expected = 0;
  constexpr int n = 200;
  for (int i = 0; i < n / 5; ++i)
    for (int j = 0; j < n; ++j) expected += proposal().density(at((i + 0.5) / n, (j + 0.5) / n)) / (n * n);
  EXPECT_NEAR(static_cast<double>(low) / count, expected, 0.012);
}

TEST(Proposal, LeavesKnownNumbersAlone) {
  RandomStream random(2, 0, 0);
  const Point unit = proposal().draw(random);
  EXPECT_EQ(unit[static_cast<std::size_t>(Unknown::friction)], 0);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
