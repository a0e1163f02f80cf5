#include "rubsweep/contact/saturation.hpp"

#include <gtest/gtest.h>

#include "rubsweep/contact/friction_coefficient.hpp"

namespace rubsweep::contact {
namespace {

TEST(SaturatedFriction, IsTheLimitOfTheCurveFromItsSpeedOn) {
  const model::Friction curve = model::StribeckFriction{{0.05, 40, 15, 0.1, 100, 0}};
  const auto limit = saturated_friction(curve);
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->coefficient, 0.1);
  for (const double factor : {1.0, 2.0, 10.0})
    EXPECT_NEAR(friction_coefficient(curve, factor * limit->above_m_per_s), 0.1, 1e-12);
  EXPECT_GT(std::abs(friction_coefficient(curve, 0.3 * limit->above_m_per_s) - 0.1), 1e-9);
}

TEST(SaturatedFriction, UnusedTermsDoNotMatter) {
  EXPECT_NEAR(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}})->above_m_per_s, 0.14,
              1e-12);
}

TEST(SaturatedFriction, ConstantAndNoneHoldAtEverySlip) {
  EXPECT_EQ(saturated_friction(model::ConstantFriction{0.2})->coefficient, 0.2);
  EXPECT_LT(saturated_friction(model::ConstantFriction{0.2})->above_m_per_s, -1e300);
  EXPECT_EQ(saturated_friction(model::NoFriction{})->coefficient, 0);
}

TEST(SaturatedFriction, ViscousFrictionNeverSaturates) {
  EXPECT_FALSE(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0.01}}));
  EXPECT_FALSE(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 0, 0}}));
}

}  // namespace
}  // namespace rubsweep::contact
