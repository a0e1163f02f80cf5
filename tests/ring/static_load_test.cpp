#include "rubsweep/ring/static_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ring/support.hpp"

namespace rubsweep::ring {
namespace {

TEST(StaticLoad, OfAStiffRingIsTheCentrifugalForceAndThePreload) {
  System system = spring_masses({60, 200}, 0.1);
  system.ring.modal_stiffness_n_per_m *= 1e9;
  system.ring.radius_m = 1.5;
  system.preload_n = 700;
  const StaticLoad load = static_load(system, 30);
  ASSERT_EQ(load.normal_n.size(), 2U);
  EXPECT_NEAR(load.normal_n[0], 100 * 1.5 * 900 + 700, 1e-3);
  EXPECT_NEAR(load.slip_m_per_s[1], 30 * 1.5, 1e-6);
  EXPECT_TRUE(load.valid());
}

TEST(StaticLoad, BalancesTheRingWithoutFriction) {
  // The ring yields outwards by u = -N n^2 / (a n^2 (Omega_c^2 - Omega^2)) at the load, which takes up k_r -
  // m Omega^2.
  System system = spring_masses({0}, 0);
  system.preload_n = 1000;
  const double speed = 10, ring = amplitude_mass_kg(system.ring) * (17.2 * 17.2 - speed * speed);
  const double own = 1e6 - 100 * speed * speed, pressing = 1000 + 100 * speed * speed;
  EXPECT_NEAR(static_load(system, speed).normal_n[0], pressing * ring / (ring + own), 1e-6 * pressing);
}

TEST(StaticLoad, ALoadLiftsOffBetweenOmegaCAndOmegaC2) {
  System system = spring_masses({0}, 0.1);
  EXPECT_TRUE(static_load(system, 100 * rpm).valid());
  EXPECT_FALSE(static_load(system, 200 * rpm).valid());
  EXPECT_LT(static_load(system, 200 * rpm).normal_n[0], 0);
  EXPECT_TRUE(static_load(system, 300 * rpm).valid());
}

TEST(StaticLoad, NothingSlipsAtRest) { EXPECT_FALSE(static_load(spring_masses({0}), 0).valid()); }

}  // namespace
}  // namespace rubsweep::ring
