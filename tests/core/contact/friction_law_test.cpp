#include "rubsweep/core/contact/friction_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contact/random_contact.hpp"

namespace rubsweep::contact {
namespace {

using Gamma = std::array<double, 6>;
using model::StribeckFriction;

/// The formula in long double, without simplification.
long double written_out(const Gamma& g, long double v) {
  return g[0] * (std::tanh(g[1] * v) - std::tanh(g[2] * v)) + g[3] * std::tanh(g[4] * v) + g[5] * v;
}

/// Size of the terms, to which rounding errors are relative.
double size_of_terms(const Gamma& g, double v) {
  return 2 * std::abs(g[0]) + std::abs(g[3]) + std::abs(g[5] * v);
}

Gamma random_gamma(RandomContact& random) {
  return {random.uniform(0, 1),   random.log_uniform(1, 1e3), random.log_uniform(0.1, 1e2),
          random.uniform(0, 0.5), random.log_uniform(1, 1e4), random.uniform(0, 0.01)};
}

/// A Stribeck curve with a static coefficient of about 0.24 near 0.01 m/s and a kinetic one of 0.1.
constexpr Gamma stribeck_dip{0.15, 200, 10, 0.1, 200, 0.001};

TEST(FrictionLawCoefficient, IsTheFormula) {
  RandomContact random(1);
  for (int trial = 0; trial < 5000; ++trial) {
    const Gamma g = random_gamma(random);
    const double v = random.either_sign(random.log_uniform(1e-6, 10));
    EXPECT_NEAR(friction_coefficient(StribeckFriction{g}, v), static_cast<double>(written_out(g, v)),
                4e-16 * size_of_terms(g, v));
  }
}

TEST(FrictionLawCoefficient, IsOdd) {
  RandomContact random(2);
  for (int trial = 0; trial < 5000; ++trial) {
    const StribeckFriction friction{random_gamma(random)};
    const double v = random.log_uniform(1e-9, 1e3);
    EXPECT_EQ(friction_coefficient(friction, -v), -friction_coefficient(friction, v));
    EXPECT_EQ(friction_slope(friction, -v), friction_slope(friction, v));
  }
}

TEST(FrictionLawCoefficient, PeaksWhereAndAsHighAsTheFormula) {
  double peak = 0, at = 0;
  long double true_peak = 0, true_at = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double v = i * 1e-5;
    if (const double mu = friction_coefficient(StribeckFriction{stribeck_dip}, v); mu > peak)
      peak = mu, at = v;
    if (const long double mu = written_out(stribeck_dip, v); mu > true_peak) true_peak = mu, true_at = v;
  }
  EXPECT_EQ(at, static_cast<double>(true_at));
  EXPECT_NEAR(peak, static_cast<double>(true_peak), 1e-16);
  EXPECT_GT(at, 0);
  EXPECT_LT(at, 0.1);
  // The slope changes sign at the peak.
  EXPECT_GT(friction_slope(StribeckFriction{stribeck_dip}, at - 1e-4), 0);
  EXPECT_LT(friction_slope(StribeckFriction{stribeck_dip}, at + 1e-4), 0);
}

TEST(FrictionLawCoefficient, SaturatesExactly) {
  const StribeckFriction friction{{0, 0, 0, 0.1, 100, 0}};
  EXPECT_LT(friction_coefficient(friction, 0.1), 0.1);
  for (const double v : {0.21, 2.0, 1e300}) {
    EXPECT_EQ(friction_coefficient(friction, v), 0.1);
    EXPECT_EQ(friction_coefficient(friction, -v), -0.1);
    EXPECT_EQ(friction_slope(friction, v), 0);
  }
}

TEST(FrictionLawCoefficient, IsContinuousWhereTheLibraryCallIsSkipped) {
  const StribeckFriction friction{{0.3, 1, 1, 0.5, 1, 0}};
  EXPECT_EQ(friction_coefficient(friction, std::nextafter(20.0, 21.0)), friction_coefficient(friction, 20.0));
  EXPECT_EQ(std::tanh(20.0), 1);
}

TEST(FrictionLawCoefficient, ExtremesStayFinite) {
  const StribeckFriction steep{{0.3, 1e4, 1e2, 0.1, 1e4, 0}};
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(friction_coefficient(steep, 0), 0);
  EXPECT_EQ(friction_slope(steep, 0), 0.3 * (1e4 - 1e2) + 0.1 * 1e4);
  EXPECT_EQ(friction_coefficient(steep, 1e300), 0.1);
  EXPECT_EQ(friction_coefficient(steep, -1e300), -0.1);
  EXPECT_EQ(friction_slope(steep, 1e300), 0);
  EXPECT_TRUE(std::isfinite(friction_coefficient(steep, smallest)));
  // The function saturates even where the product of steepness and slip overflows.
  const StribeckFriction steepest{{0.3, 1e300, 1e290, 0.1, 1e300, 0}};
  EXPECT_EQ(friction_coefficient(steepest, -1e300), -0.1);
  EXPECT_EQ(friction_slope(steepest, 1e300), 0);
}

TEST(FrictionLawSlope, IsTheDifferenceQuotient) {
  RandomContact random(3);
  for (int trial = 0; trial < 5000; ++trial) {
    const Gamma g = random_gamma(random);
    const double v = random.either_sign(random.log_uniform(1e-6, 10));
    const double steepest = std::max({g[1], g[2], g[4]});
    const long double h = 1e-5L / steepest;
    const auto quotient = static_cast<double>((written_out(g, v + h) - written_out(g, v - h)) / (2 * h));
    const double size = g[0] * (g[1] + g[2]) + g[3] * g[4] + g[5];
    EXPECT_NEAR(friction_slope(StribeckFriction{g}, v), quotient, 1e-9 * size);
  }
}

TEST(FrictionLawCoefficient, ConstantGoesByTheSignOfTheSlip) {
  const model::ConstantFriction constant{0.2};
  for (const double v : {1e300, 2.0, 1e-300}) {
    EXPECT_EQ(friction_coefficient(constant, v), 0.2);
    EXPECT_EQ(friction_coefficient(constant, -v), -0.2);
    EXPECT_EQ(friction_slope(constant, v), 0);
  }
  EXPECT_EQ(friction_coefficient(constant, 0), 0);
  EXPECT_EQ(dry_coefficient(constant), 0.2);
  EXPECT_EQ(dry_coefficient(model::OneWayFriction{0.2}), 0);
  EXPECT_EQ(dry_coefficient(model::NoFriction{}), 0);
  EXPECT_EQ(dry_coefficient(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}}), 0);
}

TEST(FrictionLawCoefficient, StaticFrictionHoldsHarderThanItSlides) {
  const model::StaticFriction law{0.3, 0.2};
  EXPECT_EQ(friction_coefficient(law, 1e-300), 0.2);
  EXPECT_EQ(friction_coefficient(law, -2), -0.2);
  EXPECT_EQ(friction_coefficient(law, 0), 0);
  EXPECT_EQ(dry_coefficient(law), 0.2);
  EXPECT_EQ(holding_coefficient(law), 0.3);
  EXPECT_TRUE(friction_terms(law).jumps());
  EXPECT_EQ(saturated_friction(law)->coefficient, 0.2);
  EXPECT_EQ(saturated_friction(law)->above_m_per_s, 0);
  EXPECT_FALSE(friction_terms(model::ConstantFriction{0.2}).jumps());
  EXPECT_FALSE(friction_terms(model::StaticFriction{0.2, 0.2}).jumps());
  EXPECT_EQ(holding_coefficient(model::ConstantFriction{0.2}), 0.2);
  EXPECT_EQ(holding_coefficient(model::OneWayFriction{0.2}), 0);
}

TEST(FrictionLawCoefficient, FallingFrictionIsTheFormulaAndItsSlopeTheDifferenceQuotient) {
  RandomContact random(4);
  for (int trial = 0; trial < 2000; ++trial) {
    const double slides = random.uniform(0, 1), holds = slides + random.uniform(0, 1);
    const double fall = random.log_uniform(1e-4, 1), v = random.either_sign(random.log_uniform(1e-6, 10));
    const int exponent = 1 + trial % 2;
    const model::FallingFriction law{holds, slides, fall, exponent};
    const auto formula = [&](long double slip) {
      const long double fallen =
          std::exp(-std::pow(std::abs(slip) / fall, static_cast<long double>(exponent)));
      return std::copysign(slides + (static_cast<long double>(holds) - slides) * fallen, slip);
    };
    EXPECT_NEAR(friction_coefficient(law, v), static_cast<double>(formula(v)), 1e-14);
    const long double h = std::min<long double>(1e-6L * fall, std::abs(v) / 2);
    EXPECT_NEAR(friction_slope(law, v), static_cast<double>((formula(v + h) - formula(v - h)) / (2 * h)),
                1e-9 / fall);
    const SaturatedFriction saturated = *saturated_friction(law);
    EXPECT_NEAR(friction_coefficient(law, saturated.above_m_per_s), saturated.coefficient, 1e-12);
  }
}

TEST(FrictionLawCoefficient, OneWayNeverReverses) {
  const model::OneWayFriction one_way{0.2};
  for (const double v : {-1e300, -2.0, -0.0, 0.0, 1e-300, 3.0}) {
    EXPECT_EQ(friction_coefficient(one_way, v), 0.2);
    EXPECT_EQ(friction_slope(one_way, v), 0);
  }
  EXPECT_TRUE(keeps_its_direction(one_way));
  EXPECT_FALSE(keeps_its_direction(model::ConstantFriction{0.2}));
}

TEST(FrictionLawCoefficient, NoneIsZero) {
  for (const double v : {-1e300, -2.0, 0.0, 3.0}) {
    EXPECT_EQ(friction_coefficient(model::NoFriction{}, v), 0);
    EXPECT_EQ(friction_slope(model::NoFriction{}, v), 0);
  }
}

TEST(FrictionLawSaturated, IsTheLimitOfTheCurveFromItsSpeedOn) {
  const model::Friction curve = model::StribeckFriction{{0.05, 40, 15, 0.1, 100, 0}};
  const auto limit = saturated_friction(curve);
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->coefficient, 0.1);
  for (const double factor : {1.0, 2.0, 10.0})
    EXPECT_NEAR(friction_coefficient(curve, factor * limit->above_m_per_s), 0.1, 1e-12);
  EXPECT_GT(std::abs(friction_coefficient(curve, 0.3 * limit->above_m_per_s) - 0.1), 1e-9);
}

TEST(FrictionLawSaturated, UnusedTermsDoNotMatter) {
  EXPECT_NEAR(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}})->above_m_per_s, 0.14,
              1e-12);
}

TEST(FrictionLawSaturated, ConstantHoldsWhileTheSlipIsForwardAndNoneAlways) {
  EXPECT_EQ(saturated_friction(model::ConstantFriction{0.2})->coefficient, 0.2);
  EXPECT_EQ(saturated_friction(model::ConstantFriction{0.2})->above_m_per_s, 0);
  EXPECT_LT(saturated_friction(model::ConstantFriction{0})->above_m_per_s, -1e300);
  EXPECT_LT(saturated_friction(model::OneWayFriction{0.2})->above_m_per_s, -1e300);
  EXPECT_EQ(saturated_friction(model::NoFriction{})->coefficient, 0);
  EXPECT_LT(saturated_friction(model::NoFriction{})->above_m_per_s, -1e300);
}

TEST(FrictionLawSaturated, ViscousFrictionNeverSaturates) {
  EXPECT_FALSE(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 100, 0.01}}));
  EXPECT_FALSE(saturated_friction(model::StribeckFriction{{0, 0, 0, 0.1, 0, 0}}));
}

}  // namespace
}  // namespace rubsweep::contact
