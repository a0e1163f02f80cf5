#include "rubsweep/core/contact/restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/contact/impact.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

TEST(RestitutionNominalDampingRatio, UnclampedOscillatorReboundsWithTheNominalRestitution) {
  for (const double e : {0.05, 0.3, 0.5, 0.7, 0.9, 0.999}) {
    const double zeta = nominal_damping_ratio(e);
    const auto unclamped = [zeta](double p, double v) { return p + 2 * zeta * v; };
    const double half_period = std::numbers::pi / std::sqrt(1 - zeta * zeta);
    EXPECT_NEAR(-speed_after_impact(unclamped, 0, half_period, 4000), e, 1e-11);
  }
}

TEST(RestitutionNominalDampingRatio, LimitsAreNoDampingAndCriticalDamping) {
  EXPECT_EQ(nominal_damping_ratio(1), 0);
  EXPECT_FALSE(std::signbit(nominal_damping_ratio(1)));
  EXPECT_NEAR(nominal_damping_ratio(1e-300), 1, 2e-5);
  EXPECT_LT(nominal_damping_ratio(std::numeric_limits<double>::denorm_min()), 1);
}

TEST(RestitutionDelivered, OfTheNominalDamping) {
  // Four-digit values on which other codes with the clamped law agree.
  EXPECT_NEAR(delivered_restitution(nominal_damping_ratio(0.3)), 0.479, 5e-4);
  EXPECT_NEAR(delivered_restitution(nominal_damping_ratio(0.5)), 0.597, 5e-4);
  EXPECT_NEAR(delivered_restitution(nominal_damping_ratio(0.7)), 0.736, 5e-4);
  EXPECT_NEAR(delivered_restitution(nominal_damping_ratio(0.9)), 0.904, 5e-4);
}

TEST(RestitutionDelivered, IsWhatASimulatedImpactReturns) {
  for (const double zeta : {0.0, 1e-3, 0.02, 0.11, 0.13498, 0.32671, 0.5, 0.8, 0.99, 0.999999}) {
    const auto clamped = [zeta](double p, double v) { return elastogap(1, 2 * zeta, p, v).total_n; };
    // The contact ends after pi / sqrt(1 - zeta^2) at the latest; the free mass then keeps its speed.
    const double rebound = -speed_after_impact(clamped, 0, 6, 100'000);
    EXPECT_NEAR(delivered_restitution(zeta), rebound, 5e-10) << "zeta = " << zeta;
  }
}

TEST(RestitutionDelivered, FallsWithDampingAndNeverBelowTheNominal) {
  double previous = 1;
  for (int i = 1; i < 1000; ++i) {
    const double zeta = i / 1000.0;
    const double delivered = delivered_restitution(zeta);
    EXPECT_LT(delivered, previous);
    EXPECT_GT(delivered, std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta)));
    previous = delivered;
  }
}

TEST(RestitutionDelivered, AtCriticalDampingByHand) {
  // tan(clamp phase) = 2 sqrt 2, so p = 2/3 and v = 1/3 where the clamp ends. Then p = e^{-t} (2/3 + t),
  // whose acceleration vanishes at t = 4/3 with v = -e^{-4/3}.
  EXPECT_NEAR(delivered_restitution(1 - 1e-9), std::exp(-4.0 / 3), 1e-8);
}

TEST(RestitutionDampingRatioDelivering, KnownValues) {
  EXPECT_NEAR(damping_ratio_delivering(0.5), 0.32671, 5e-6);
  EXPECT_NEAR(damping_ratio_delivering(0.7), 0.13498, 5e-6);
  EXPECT_EQ(damping_ratio_delivering(1), 0);
}

TEST(RestitutionDampingRatioDelivering, IsTheInverse) {
  for (int i = 1; i <= 500; ++i) {
    const double e = 0.2636 + (1 - 0.2636) * i / 500.0;
    EXPECT_NEAR(delivered_restitution(damping_ratio_delivering(e)), e, 1e-15) << e;
  }
  for (const double zeta : {1e-6, 0.01, 0.1, 0.5, 0.9}) {
    EXPECT_NEAR(damping_ratio_delivering(delivered_restitution(zeta)), zeta, 1e-14) << zeta;
  }
}

TEST(RestitutionDampingRatioDelivering, OutsideWhatTheClampCanDeliverIsAnError) {
  const std::string message =
      "restitution_delivered: the clamped contact delivers 0.263597 at the least, allowed: a number > "
      "0.263597 and "
      "<= 1";
  for (const double e : {-0.1, 0.0, 0.1, 0.2635, 1.0001, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(message_of<ConfigError>([e] { damping_ratio_delivering(e); }), message) << e;
  }
}

TEST(RestitutionDampingConstant, IsCriticalAtRatioOne) {
  // Critical damping: m s^2 + d s + K has a double root for d^2 = 4 m K.
  const double d = damping_constant(1, 0.8, 2e6);
  EXPECT_NEAR(d * d / (4 * 0.8 * 2e6), 1, 1e-15);
  EXPECT_DOUBLE_EQ(damping_constant(0.25, 0.8, 2e6), d / 4);
}

TEST(RestitutionReducedMass, Limits) {
  EXPECT_DOUBLE_EQ(reduced_mass(0.8, 0.8), 0.4);
  EXPECT_EQ(reduced_mass(0.8, 0.05), reduced_mass(0.05, 0.8));
  EXPECT_NEAR(1 / reduced_mass(0.8, 0.05), 1 / 0.8 + 1 / 0.05, 1e-14);
  EXPECT_NEAR(reduced_mass(0.8, 1e12), 0.8, 1e-12);
  EXPECT_NEAR(reduced_mass(0.8, 1e-12), 1e-12, 1e-23);
}

}  // namespace
}  // namespace rubsweep::contact
