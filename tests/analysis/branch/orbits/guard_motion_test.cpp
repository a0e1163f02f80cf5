#include "rubsweep/analysis/branch/orbits/guard_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/simple_scenes.hpp"

namespace rubsweep::branch::orbits {
namespace {

using contact::Mode;

/// A mass of 2 kg on 8 N/m, driven by 3 cos t, at a speed of 1 rad/s, lengths in metres; a wall at 1 m.
scene::Scene driven_mass(double damping) {
  scene::Scene scene = test::one_mass_scene(2, 8, 0, 2 * std::numbers::pi, 1);
  scene.harmonic_n << 3, 0;
  scene.contacts.push_back(test::wall_across_x(1, 1, 50, damping));
  return scene;
}

TEST(GuardMotionSection, AnOpenContactInClosedForm) {
  SectionGuards guards(driven_mass(0));
  const std::array section{0.9, 0.1, 0.2, -0.3};
  const auto guard = guards.at(section, {0, Mode::open, Mode::sprung});
  ASSERT_TRUE(guard);
  EXPECT_NEAR(guard->value, 0.9 - 1, 1e-15);
  EXPECT_NEAR(guard->rate, 0.2, 1e-15);
  EXPECT_NEAR(guard->curvature, (3 - 8 * 0.9) / 2, 1e-9);
  EXPECT_FALSE(guards.at(section, {0, Mode::open, Mode::clamped}));  // without a damper it leads to sprung
}

/// K p + d v over K, its rate by the acceleration of a sprung contact.
TEST(GuardMotionSection, AForceThatEndsInUnitsOfLength) {
  SectionGuards guards(driven_mass(5));
  const std::array section{1.2, 0.0, -0.4, 0.0};
  const auto guard = guards.at(section, {0, Mode::sprung, Mode::released});
  ASSERT_TRUE(guard);
  EXPECT_NEAR(guard->value, -(50 * 0.2 - 5 * 0.4) / 50, 1e-14);
  const double acceleration = (3 - 8 * 1.2 - (50 * 0.2 - 5 * 0.4)) / 2;
  EXPECT_NEAR(guard->rate, -(50 * -0.4 + 5 * acceleration) / 50, 1e-14);
}

TEST(GuardMotionBegunAtPhase, TurnsForceAndImpulses) {
  scene::Scene scene = driven_mass(0);
  scene.impulses.push_back({Eigen::Vector2d(1, 0), 2, 0.25});
  scene.second_harmonic_n = Eigen::Vector2cd(2, 0);
  const scene::Scene later = begun_at_phase(scene, std::numbers::pi / 2);
  EXPECT_NEAR(std::abs(later.second_harmonic_n(0) + 2.0), 0, 1e-15);
  EXPECT_NEAR(std::abs(later.harmonic_n(0) - std::complex<double>(0, 3)), 0, 1e-15);
  // Two impulses a turn, the first one an eighth of a turn after the start: a quarter later it is the next
  // one.
  EXPECT_NEAR(later.impulses[0].phase_periods, 0.75, 1e-15);
}

}  // namespace
}  // namespace rubsweep::branch::orbits
