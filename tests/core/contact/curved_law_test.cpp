#include "rubsweep/core/contact/curved_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/model/stop.hpp"

namespace rubsweep::contact {
namespace {

using model::ForceCurve;
using model::ImpactDamping;

model::Stop power_stop(double stiffness, double exponent) {
  model::Stop stop;
  stop.law.kind = ForceCurve::power;
  stop.law.stiffness_n_per_m_n = stiffness;
  stop.law.exponent = exponent;
  return stop;
}

model::Stop line_stop() {
  model::Stop stop;
  stop.law.kind = ForceCurve::hertz_line;
  stop.hertz = model::HertzLine{.length_m = 0.01,
                                .rotor = {0.02, 2e11, 0.3},
                                .casing = {0.021, 1e11, 0.33},
                                .casing_shape = model::HertzShape::hole,
                                .design_force_n = 100};
  return stop;
}

model::Stop felt_stop() {
  model::Stop stop;
  stop.law.kind = ForceCurve::table;
  stop.law.penetration_m = {0, 1e-4, 3e-4, 4e-4, 1e-3};
  stop.law.force_n = {0, 1, 9, 30, 400};
  return stop;
}

/// Restitution of a free unit mass that hits p^n (1 + x p') at unit speed. Classical Runge-Kutta method, with
/// shorter steps towards both ends of the contact, where p^n is not smooth.
double simulated_restitution(double n, double x) {
  using Real = long double;
  const auto force = [&](Real p, Real v) { return p > 0 ? -std::pow(p, Real(n)) * (1 + Real(x) * v) : 0; };
  Real p = 0, v = 1;
  for (Real h = 1e-9L; p >= 0;) {
    const Real a1 = force(p, v), v2 = v + h / 2 * a1, a2 = force(p + h / 2 * v, v2);
    const Real v3 = v + h / 2 * a2, a3 = force(p + h / 2 * v2, v3);
    const Real v4 = v + h * a3, a4 = force(p + h * v3, v4);
    p += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    h = std::clamp(p / (100 * std::abs(v)), 1e-9L, 1e-3L);
  }
  return double(-v);
}

TEST(CurvedLaw, EachDampingReturnsWhatAnImpactReturnsWhateverTheExponent) {
  for (const ImpactDamping damping : model::impact_dampings.values) {
    for (const double e : {0.2, 0.5, 0.9}) {
      const double factor = damping_factor(damping, e);
      for (const double n : {1.0, 1.5, 3.0})
        EXPECT_NEAR(restitution_of_factor(factor), simulated_restitution(n, factor), 1e-9) << e << " " << n;
    }
  }
}

TEST(CurvedLaw, DeliveredDeliversEveryRestitution) {
  for (double e = 1; e > 1e-3; e *= 0.83)
    EXPECT_NEAR(restitution_of_factor(damping_factor(ImpactDamping::delivered, e)), e, 4e-15) << e;
  EXPECT_NEAR(restitution_of_factor(damping_factor(ImpactDamping::delivered, 1 - 1e-9)), 1 - 1e-9, 1e-15);
  EXPECT_EQ(damping_factor(ImpactDamping::delivered, 1), 0);
}

TEST(CurvedLaw, TheOtherFormulasAgreeWithItNearOneOnly) {
  // All four formulas have the series 1 - e = 2 x / 3 + O(x^2) of the first integral, except for the factor 5
  // / 8 of Flores.
  constexpr double e = 0.9999;
  EXPECT_NEAR(restitution_of_factor(damping_factor(ImpactDamping::hunt_crossley, e)), e, 1e-7);
  EXPECT_NEAR(restitution_of_factor(damping_factor(ImpactDamping::lankarani_nikravesh, e)), e, 1e-7);
  EXPECT_NEAR(1 - restitution_of_factor(damping_factor(ImpactDamping::flores, e)), 1.6 * 2 / 3 * (1 - e),
              1e-7);
  EXPECT_GT(restitution_of_factor(damping_factor(ImpactDamping::hunt_crossley, 0.5)), 0.55);
  EXPECT_GT(restitution_of_factor(damping_factor(ImpactDamping::lankarani_nikravesh, 0.1)), 0.6);
}

TEST(CurvedLaw, LineContactIsTheInverseOfItsApproach) {
  const model::Stop stop = line_stop();
  const CurvedLaw law(stop);
  const double widest_n = std::pow(stop.hertz->length_m / (2 * hertz_half_width_m(*stop.hertz, 1)), 2);
  for (double force = 1e-6; force < widest_n; force *= 7)
    EXPECT_NEAR(law.force_n(hertz_approach_m(*stop.hertz, force)) / force, 1, 1e-12) << force;
  EXPECT_EQ(law.force_n(0), 0);
  // Above the force at which the contact area is as wide as long, the law continues along its tangent.
  const double at_end = hertz_approach_m(*stop.hertz, widest_n);
  EXPECT_NEAR(law.slope_n_per_m(1.5 * at_end) / law.slope_n_per_m(0.9999 * at_end), 1, 1e-4);
  EXPECT_NEAR(law.force_n(1.1 * at_end), widest_n + 0.1 * at_end * law.slope_n_per_m(2 * at_end),
              1e-9 * widest_n);
  const double secant = hertz_stiffness_n_per_m(*stop.hertz);
  EXPECT_NEAR(law.force_n(100 / secant), 100, 1e-10);
}

TEST(CurvedLaw, SlopeAndEnergyBelongToTheForce) {
  for (const model::Stop& stop :
       {power_stop(1e9, 1.5), power_stop(1e5, 1), power_stop(1e12, 3), line_stop(), felt_stop()}) {
    const CurvedLaw law(stop);
    for (const double p : {1e-5, 2e-4, 5e-4, 2e-3}) {
      const double h = 1e-5 * p;
      const double rise = law.force_n(p + h) - law.force_n(p - h);
      EXPECT_NEAR(law.slope_n_per_m(p) * 2 * h / rise, 1, 1e-6) << p;
      EXPECT_NEAR((law.energy_j(p + h) - law.energy_j(p - h)) / (2 * h * law.force_n(p)), 1, 1e-6) << p;
      EXPECT_EQ(law.force_n(-p), -law.force_n(p));
    }
    EXPECT_NEAR(law.energy_j(0), 0, 1e-30);
  }
}

TEST(CurvedLaw, MeasuredCurveMeetsItsPointsAndRisesBeyondThem) {
  const model::Stop felt = felt_stop();
  const CurvedLaw law(felt);
  for (std::size_t i = 0; i < felt.law.force_n.size(); ++i)
    EXPECT_NEAR(law.force_n(felt.law.penetration_m[i]), felt.law.force_n[i], 1e-12);
  for (double p = 0; p < 2e-3; p += 1e-6) EXPECT_GT(law.force_n(p + 1e-6), law.force_n(p)) << p;
}

TEST(CurvedLaw, SecondDerivativesJumpAtItsKnots) {
  for (const model::Stop& stop : {line_stop(), felt_stop(), power_stop(1e6, 1.5)}) {
    const CurvedLaw law(stop);
    EXPECT_EQ(law.knots_m().size(), stop.law.kind == ForceCurve::table        ? 4U
                                    : stop.law.kind == ForceCurve::hertz_line ? 1U
                                                                              : 0U);
    for (const double knot_m : law.knots_m()) {
      const double h = 1e-4 * knot_m, here = law.slope_n_per_m(knot_m);
      const double before = (here - law.slope_n_per_m(knot_m - h)) / h,
                   after = (law.slope_n_per_m(knot_m + h) - here) / h;
      EXPECT_GT(std::abs(after - before) * knot_m, 0.1 * here) << knot_m;
    }
  }
}

TEST(CurvedLaw, ReleasesWhereTheForceWouldPull) {
  EXPECT_EQ(curved_mode(2, -1e-9, 1), Mode::open);
  EXPECT_EQ(curved_mode(2, 1e-9, -0.4), Mode::sprung);
  EXPECT_EQ(curved_mode(2, 1e-9, -0.5), Mode::released);
  const Guards pulling = curved_guards(Mode::sprung, 2, {0.1, -0.6, -1});
  EXPECT_EQ(pulling.count, 2);
  EXPECT_EQ(pulling.list[1].next, Mode::released);
  EXPECT_GT(pulling.list[1].value, 0);
  EXPECT_GT(pulling.list[1].rate, 0);
  EXPECT_EQ(curved_guards(Mode::sprung, 0, {0.1, -0.6, -1}).count, 1);
}

TEST(CurvedLaw, SecantIsThatAtATwentiethOfTheClearance) {
  model::Stop stop = power_stop(1e9, 1.5);
  stop.clearance_m = 1e-3;
  EXPECT_NEAR(secant_n_per_m(stop), 1e9 * std::sqrt(5e-5), 1e-3);
}

/// Hunt & Crossley print F = k p^n (1 + 3/2 a v) for a restitution of 1 - a v at small speeds v. To first
/// order in a v such an impact has this restitution.
TEST(CurvedLaw, SmallImpactsReturnWhatHuntAndCrossleyPrint) {
  for (const double share : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const double lost = 1 - restitution_of_factor(1.5 * share);
    EXPECT_LT(lost, share);
    EXPECT_GT(lost, share * (1 - share));
  }
}

}  // namespace
}  // namespace rubsweep::contact
