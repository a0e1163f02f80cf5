#include "rubsweep/core/contact/force_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contact/impact.hpp"
#include "core/contact/random_contact.hpp"
#include "rubsweep/core/contact/restitution.hpp"

namespace rubsweep::contact {
namespace {

constexpr double rounding = 1e-15;  // a few units in the last place of the largest term

struct Law {
  double stiffness, damping, width;

  NormalForce exact(double p, double v) const { return elastogap(stiffness, damping, p, v); }
  NormalForce smooth(double p, double v) const { return smoothed_elastogap(stiffness, damping, p, v, width); }
};

Law random_law(RandomContact& random) {
  return {random.stiffness(), random.damping(), random.log_uniform(1e-10, 1e-4)};
}

struct State {
  double p, v;
};

/// States near the corners of the law: around first touch, around both clamp lines d v = +-K p, and anywhere.
State random_state(RandomContact& random, const Law& law, int kind) {
  const double p = random.penetration();
  const double near = 1 + random.either_sign(random.log_uniform(1e-12, 0.5));
  if (kind % 4 == 0) return {p, random.speed()};
  if (kind % 4 == 1) return {random.uniform(-1, 1) * law.width, random.speed()};
  const double on_clamp_line = law.stiffness * std::abs(p) / law.damping * near;
  return {std::abs(p), kind % 4 == 2 ? on_clamp_line : -on_clamp_line};
}

TEST(ForceLawElastogap, IsTheMiddleOfNothingOscillatorAndTwiceTheSpring) {
  RandomContact random(1);
  for (int trial = 0; trial < 20'000; ++trial) {
    const Law law = random_law(random);
    const auto [p, v] = random_state(random, law, trial);
    const double spring = law.stiffness * std::max(p, 0.0);
    const auto [spring_n, total_n] = law.exact(p, v);
    EXPECT_EQ(spring_n, spring);
    EXPECT_EQ(total_n, p > 0 ? std::max(0.0, std::min(2 * spring, spring + law.damping * v)) : 0);
  }
}

TEST(ForceLawElastogap, NeverPullsAndTheDamperNeverExceedsTheSpring) {
  RandomContact random(2);
  for (int trial = 0; trial < 20'000; ++trial) {
    const Law law = random_law(random);
    const auto [p, v] = random_state(random, law, trial);
    const auto [spring_n, total_n] = law.exact(p, v);
    EXPECT_GE(total_n, 0);
    EXPECT_LE(std::abs(total_n - spring_n), spring_n);
  }
}

TEST(ForceLawElastogap, NothingBeforeTouch) {
  for (const double p : {-0.0, 0.0, -1e-300, -1e-9, -1.0}) {
    for (const double v : {-1e300, -1.0, 0.0, 1.0, 1e300}) {
      EXPECT_EQ(elastogap(2e6, 100, p, v).spring_n, 0);
      EXPECT_EQ(elastogap(2e6, 100, p, v).total_n, 0);
    }
  }
}

TEST(ForceLawElastogap, FiniteAtTheCornersOfTheState) {
  for (const double damping : {0.0, 100.0}) {
    for (const double p : {0.0, 4.9e-324, 1.0}) {
      for (const double v : {0.0, 4.9e-324, 1e308}) {
        EXPECT_TRUE(std::isfinite(elastogap(2e6, damping, p, v).total_n));
        EXPECT_TRUE(std::isfinite(elastogap(2e6, damping, p, -v).total_n));
      }
    }
  }
}

TEST(ForceLawElastogap, IsLipschitzInTheState) {
  // In every mode the slope with respect to p is at most 2 K, with respect to v at most d. This bounds the
  // difference in force between any two states.
  RandomContact random(3);
  for (int trial = 0; trial < 40'000; ++trial) {
    const Law law = random_law(random);
    const State a = random_state(random, law, trial);
    const double dp = random.either_sign(random.log_uniform(1e-14, 1e-3));
    const double dv = random.either_sign(random.log_uniform(1e-12, 10));
    const auto fa = law.exact(a.p, a.v), fb = law.exact(a.p + dp, a.v + dv);
    const double size =
        law.stiffness * (std::abs(a.p) + std::abs(dp)) + law.damping * (std::abs(a.v) + std::abs(dv));
    EXPECT_LE(std::abs(fb.spring_n - fa.spring_n), law.stiffness * std::abs(dp) + rounding * size);
    EXPECT_LE(std::abs(fb.total_n - fa.total_n),
              2 * law.stiffness * std::abs(dp) + law.damping * std::abs(dv) + rounding * size);
  }
}

TEST(ForceLawSmoothRamp, IsExactOutsideTheBlendAndAboveTheCornerInside) {
  for (const double y : {-2.0, -0.5, 0.5, 0.7, 2.0}) EXPECT_EQ(smooth_ramp(y, 1), std::max(y, 0.0));
  EXPECT_EQ(smooth_ramp(0, 1), 0.125);
  for (int i = -499; i < 500; ++i) {
    const double y = i / 1000.0;
    EXPECT_GT(smooth_ramp(y, 1), std::max(y, 0.0));
    EXPECT_LE(smooth_ramp(y, 1), std::max(y, 0.0) + 0.125);
  }
}

TEST(ForceLawSmoothRampSlope, IsTheDifferenceQuotient) {
  for (const double width : {1e-9, 1e-3, 1.0, 1e4}) {
    for (int i = -300; i <= 300; ++i) {
      // The points avoid the ends of the blend, where the second derivative jumps and a central difference
      // would average both sides.
      const double y = (i + 0.5) / 200 * width, h = 1e-4 * width;
      const double quotient = (smooth_ramp(y + h, width) - smooth_ramp(y - h, width)) / (2 * h);
      EXPECT_NEAR(smooth_ramp_slope(y, width), quotient, 1e-11);
    }
  }
}

TEST(ForceLawSmoothedElastogap, NeverPullsAndTheDamperNeverExceedsTheSpring) {
  RandomContact random(4);
  for (int trial = 0; trial < 40'000; ++trial) {
    const Law law = random_law(random);
    const auto [p, v] = random_state(random, law, trial);
    const auto [spring_n, total_n] = law.smooth(p, v);
    EXPECT_GE(spring_n, 0);
    EXPECT_GE(total_n, 0);
    EXPECT_LE(total_n, 2 * spring_n);
    if (p <= -law.width / 2) {
      EXPECT_EQ(total_n, 0);
    }
  }
}

TEST(ForceLawSmoothedElastogap, DiffersFromTheExactLawOnlyWithinTheBlend) {
  RandomContact random(5);
  int inside_blend = 0;
  for (int trial = 0; trial < 40'000; ++trial) {
    const Law law = random_law(random);
    const auto [p, v] = random_state(random, law, trial);
    const double spring = law.stiffness * p, damper = law.damping * v, half = law.stiffness * law.width / 2;
    const auto exact = law.exact(p, v), smooth = law.smooth(p, v);
    const double tolerance = rounding * (std::abs(spring) + std::abs(damper));
    // At each of the three corners the smooth law deviates by at most an eighth of the width; inside the
    // clamp the spring's corner counts twice.
    EXPECT_NEAR(smooth.total_n, exact.total_n, half + tolerance);
    EXPECT_NEAR(smooth.spring_n, exact.spring_n, half / 4 + tolerance);
    const bool blended = std::abs(spring) < half || std::abs(std::abs(damper) - spring) < half;
    if (blended) {
      ++inside_blend;
    } else {
      EXPECT_NEAR(smooth.total_n, exact.total_n, tolerance);
    }
  }
  EXPECT_GT(inside_blend, 1000);
}

/// Difference between the slopes just right and just left of 0 for a function f.
double kink(const auto& f, double h) { return (f(h) - f(0)) / h - (f(0) - f(-h)) / h; }

TEST(ForceLawSmoothedElastogap, HasNoKink) {
  // In units of the contact, K = d = width = 1, second derivatives are at most 4. Slopes may therefore differ
  // by 4 h.
  const double h = 1e-6, allowed = 4 * h + 1e-9;
  const Law law{1, 1, 1};
  for (int i = -60; i <= 120; ++i) {
    for (int j = -120; j <= 120; ++j) {
      // Multiples of a quarter width hit every seam of the blend exactly.
      const double p = i / 40.0, v = j / 40.0;
      EXPECT_LE(std::abs(kink([&](double dp) { return law.smooth(p + dp, v).total_n; }, h)), allowed);
      EXPECT_LE(std::abs(kink([&](double dv) { return law.smooth(p, v + dv).total_n; }, h)), allowed);
      EXPECT_LE(std::abs(kink([&](double dp) { return law.smooth(p + dp, v).spring_n; }, h)), allowed);
    }
  }
  // The same measure detects the corners of the exact law.
  EXPECT_NEAR(kink([&](double dp) { return law.exact(dp, 0.5).total_n; }, h), 2, 1e-6);
  EXPECT_NEAR(kink([&](double dv) { return law.exact(1, 1 + dv).total_n; }, h), -1, 1e-6);
  EXPECT_NEAR(kink([&](double dv) { return law.exact(1, -1 + dv).total_n; }, h), 1, 1e-6);
}

TEST(ForceLawSmoothedElastogap, ImpulseOfAnImpactConvergesWithTheSquareOfTheWidth) {
  const double zeta = 0.2, exact = delivered_restitution(zeta);
  std::vector<double> errors;
  for (const double width : {0.1, 0.05, 0.025, 0.0125}) {
    const auto force = [&](double p, double v) {
      return smoothed_elastogap(1, 2 * zeta, p, v, width).total_n;
    };
    errors.push_back(std::abs(-speed_after_impact(force, -0.1, 6, 20'000) - exact));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2, 0.1) << errors[i];
  }
}

}  // namespace
}  // namespace rubsweep::contact
