#include "rubsweep/core/contact/stribeck_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

model::StribeckCurve dry(double static_coefficient = 0.3) {
  return {.static_coefficient = static_coefficient,
          .kinetic = 0.2,
          .peak_speed_m_per_s = 0.01,
          .settle_speed_m_per_s = 0.2,
          .viscous_s_per_m = 0};
}

double highest(const model::Friction& friction, double up_to) {
  double most = 0;
  for (int i = 0; i <= 100000; ++i) most = std::max(most, friction_coefficient(friction, up_to * i / 100000));
  return most;
}

TEST(StribeckCurve, PeakIsTheStaticCoefficient) {
  for (const double viscous : {0.0, 0.05, 0.3}) {
    for (const double level : {0.22, 0.3, 0.6}) {
      model::StribeckCurve curve = dry(level);
      curve.viscous_s_per_m = viscous;
      EXPECT_NEAR(highest(stribeck_of(curve), 0.2), level, 1e-8) << viscous << ' ' << level;
    }
  }
}

TEST(StribeckCurve, OtherCoefficientsAreThoseOfTheLibrary) {
  model::StribeckCurve curve = dry();
  curve.viscous_s_per_m = 0.1;
  const auto gamma = stribeck_of(curve).gamma;
  EXPECT_GT(gamma[0], 0);
  EXPECT_DOUBLE_EQ(gamma[1], 200);
  EXPECT_DOUBLE_EQ(gamma[2], 15);
  EXPECT_DOUBLE_EQ(gamma[3], 0.2 - 0.02);
  EXPECT_DOUBLE_EQ(gamma[4], 200);
  EXPECT_DOUBLE_EQ(gamma[5], 0.1);
}

TEST(StribeckCurve, SettlesAtTheKineticCoefficientAndGrowsViscouslyBeyond) {
  model::StribeckCurve curve = dry();
  curve.viscous_s_per_m = 0.1;
  const model::Friction friction = stribeck_of(curve);
  EXPECT_NEAR(friction_coefficient(friction, 0.2), 0.2, 0.01 * 0.2);
  EXPECT_NEAR(friction_coefficient(friction, 2.0), 0.18 + 0.2, 1e-6);
}

TEST(StribeckCurve, SpeedsTooFarApartAreRefusedInsteadOfSearchedForEver) {
  for (const double settle : {1e5, 1e30, 1.7e308}) {
    model::StribeckCurve curve = dry();
    curve.settle_speed_m_per_s = settle;
    EXPECT_THROW(stribeck_of(curve), ConfigError) << settle;
  }
  model::StribeckCurve curve = dry();
  curve.settle_speed_m_per_s = 1e3;
  EXPECT_NO_THROW(stribeck_of(curve));
}

TEST(StribeckCurve, NumbersThatNoCurveHas) {
  EXPECT_THROW(stribeck_of(dry(0.1)), ConfigError);
  model::StribeckCurve curve = dry();
  curve.settle_speed_m_per_s = 0.012;
  EXPECT_THROW(stribeck_of(curve), ConfigError);
}

}  // namespace
}  // namespace rubsweep::contact
