#include "rubsweep/analysis/linear/critical_speeds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::linear {
namespace {

/// A Jeffcott rotor of 30 Hz whose whirl does not depend on the speed.
model::Machine jeffcott(double damping_ratio) {
  model::Machine machine;
  machine.rotor =
      model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = damping_ratio};
  return machine;
}

std::vector<FollowedMode> first_mode(const WhirlProblem& problem, std::span<const double> speeds_hz) {
  std::vector<FollowedMode> curve;
  for (const double speed_hz : speeds_hz) curve.push_back({speed_hz, problem.at(speed_hz).modes.front()});
  return curve;
}

TEST(CriticalSpeeds, OfAJeffcottRotorIsItsDampedFrequency) {
  const FreeRotor rotor = free_rotor(jeffcott(0.1));
  const std::array speeds_hz{10.0, 25.0, 50.0};
  const WhirlProblem problem(rotor, speeds_hz, 100);
  const auto found = critical_points(problem, first_mode(problem, speeds_hz));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].speed_hz, 30 * std::sqrt(1 - 0.01), 1e-10);
  EXPECT_NEAR(found[0].mode.damping_ratio(), 0.1, 1e-10);
}

TEST(CriticalSpeeds, AreNoneWhereTheSpeedStaysBelowTheFrequency) {
  const FreeRotor rotor = free_rotor(jeffcott(0.1));
  const std::array speeds_hz{10.0, 25.0};
  const WhirlProblem problem(rotor, speeds_hz, 100);
  EXPECT_TRUE(critical_points(problem, first_mode(problem, speeds_hz)).empty());
}

}  // namespace
}  // namespace rubsweep::linear
