#include "rubsweep/core/contact/friction_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/stribeck_curve.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

using model::StribeckFriction;

bool brakes(const model::Friction& friction) { return contact::brakes(friction_bounds(friction)); }

TEST(FrictionBounds, TellsFrictionThatDrives) {
  EXPECT_FALSE(brakes(StribeckFriction{{0, 0, 0, -0.1, 100, 0}}));
  EXPECT_FALSE(brakes(StribeckFriction{{0, 0, 0, 0.1, -100, 0}}));  // the same with opposite sign
  EXPECT_FALSE(brakes(StribeckFriction{{0.3, 10, 100, 0, 0, 0}}));  // a peak below zero
  EXPECT_FALSE(brakes(StribeckFriction{{0.3, 10, 100, 0.1, 1, 0}}));
  EXPECT_FALSE(brakes(StribeckFriction{{0, 0, 0, 0.2, 50, -1e-9}}));  // negative only at the highest slip
  EXPECT_FALSE(brakes(StribeckFriction{{0, 0, 0, 11, 50, 0}}));
  EXPECT_TRUE(brakes(StribeckFriction{{0, 0, 0, 0.1, 100, 0}}));
  EXPECT_TRUE(brakes(StribeckFriction{{0, 0, 0, -0.1, -100, 0}}));
  EXPECT_TRUE(brakes(StribeckFriction{{0, 5, -3, 0, 7, 0}}));
  EXPECT_TRUE(brakes(StribeckFriction{{0, 0, 0, 0, 0, 2}}));
  EXPECT_TRUE(brakes(StribeckFriction{{0.1, 100, 10, 0.2, 100, 0.01}}));
  EXPECT_TRUE(brakes(model::NoFriction{}));
  EXPECT_TRUE(brakes(model::ConstantFriction{0.3}));
  EXPECT_TRUE(brakes(model::OneWayFriction{0.3}));
  const model::StribeckCurve curve{
      .static_coefficient = 0.3, .kinetic = 0.2, .peak_speed_m_per_s = 0.01, .settle_speed_m_per_s = 0.5};
  EXPECT_TRUE(brakes(stribeck_of(curve)));
  EXPECT_NEAR(friction_bounds(stribeck_of(curve)).largest, 0.3, 1e-9);
}

TEST(FrictionBounds, AreThoseOfADenseScan) {
  std::mt19937 random(3);
  std::normal_distribution<double> height(0, 0.3), decade(0, 1.5);
  int driving = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto steepness = [&] { return std::pow(10, 1 + decade(random)); };
    const StribeckFriction friction{
        {height(random), steepness(), steepness(), std::abs(height(random)), steepness(), 0}};
    const FrictionBounds bounds = friction_bounds(friction);
    double smallest = 1, largest = -1;
    for (int k = 0; k <= 30000; ++k) {
      const double mu = friction_coefficient(friction, std::pow(10, -9 + 16.0 * k / 30000));
      smallest = std::min(smallest, mu);
      largest = std::max(largest, mu);
    }
    EXPECT_LE(bounds.largest, largest + 1e-6);
    EXPECT_GE(bounds.largest, largest - 1e-12);
    if (smallest < -1e-6) {
      ++driving;
      EXPECT_LE(bounds.smallest, smallest + 1e-12);
      EXPECT_GE(bounds.smallest, smallest - 1e-6);
      EXPECT_NEAR(friction_coefficient(friction, bounds.smallest_at_m_per_s), bounds.smallest, 1e-12);
    }
  }
  EXPECT_GT(driving, 10);
}

TEST(FrictionBoundsRefuseDriving, SaysWhichFrictionAndWhatIsAllowed) {
  EXPECT_NO_THROW(refuse_driving(model::ConstantFriction{0.1}, "stops.0.friction"));
  try {
    refuse_driving(StribeckFriction{{0, 0, 0, -0.1, 100, 0}}, "stops.1.friction");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()),
              "stops.1.friction: a coefficient from -0.1 to -1e-05, allowed: one that is >= 0 at every slip "
              "speed and, without its viscous part, <= 10");
  }
}

}  // namespace
}  // namespace rubsweep::contact
