#include "rubsweep/core/contact/hertz_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

using std::numbers::pi;

/// A steel shaft of 10 mm diameter on a brass screw of 6 mm diameter.
model::HertzLine steel_on_brass(model::HertzShape shape = model::HertzShape::cylinder,
                                double casing_radius_m = 3e-3) {
  return {.length_m = 0.01,
          .rotor = {.radius_m = 5e-3, .youngs_modulus_pa = 2.06e11, .poisson_ratio = 0.3},
          .casing = {.radius_m = casing_radius_m, .youngs_modulus_pa = 1.0e11, .poisson_ratio = 0.34},
          .casing_shape = shape,
          .design_force_n = 200};
}

double both_compliances() { return (1 - 0.09) / 2.06e11 + (1 - 0.34 * 0.34) / 1.0e11; }

TEST(HertzLine, RelativeRadiusOfEachShape) {
  using enum model::HertzShape;
  EXPECT_NEAR(relative_radius_m(steel_on_brass(cylinder)), 5e-3 * 3e-3 / 8e-3, 1e-18);
  EXPECT_EQ(relative_radius_m(steel_on_brass(flat)), 5e-3);
  EXPECT_NEAR(relative_radius_m(steel_on_brass(hole, 6e-3)), 30e-3, 1e-16);
}

TEST(HertzLine, HalfWidthBalancesPressureAndCurvature) {
  // Hertz: the highest pressure is both 2 F / (pi b L) and b / (2 R (k0 + k1)).
  const auto contact = steel_on_brass();
  for (const double force : {1.0, 50.0, 3000.0}) {
    const double b = hertz_half_width_m(contact, force);
    const double by_force = 2 * force / (pi * b * contact.length_m);
    EXPECT_NEAR(by_force, b / (2 * relative_radius_m(contact) * both_compliances()), 1e-12 * by_force);
  }
}

TEST(HertzLine, ApproachIsTheDisplacementInTheMiddleOfTheStrip) {
  // Two half-spaces under Hertz's pressure on an area L x 2b: u = k / pi * integral of pressure / distance.
  // The integral over the length is 2 asinh(L / 2|x|); the one over the width, with x = b sin(phi), uses the
  // midpoint rule.
  for (const double force : {1.0, 200.0}) {
    const auto contact = steel_on_brass();
    const double b = hertz_half_width_m(contact, force), length = contact.length_m;
    constexpr int steps = 200000;
    double integral = 0;
    for (int i = 0; i < steps; ++i) {
      const double phi = -pi / 2 + pi * (i + 0.5) / steps;
      const double pressure = 2 * force / (pi * b * length) * std::cos(phi);
      integral += pressure * 2 * std::asinh(length / (2 * b * std::abs(std::sin(phi)))) * b * std::cos(phi) *
                  pi / steps;
    }
    const double displacement = both_compliances() / pi * integral;
    EXPECT_NEAR(hertz_approach_m(contact, force), displacement, 2e-5 * displacement);
  }
}

TEST(HertzLine, SecantStiffnessReturnsTheDesignForce) {
  const auto contact = steel_on_brass();
  const double stiffness = hertz_stiffness_n_per_m(contact);
  EXPECT_NEAR(stiffness * hertz_approach_m(contact, 200), 200, 1e-10);
  EXPECT_GT(stiffness, 5e7);  // typical size for steel on brass
  EXPECT_LT(stiffness, 1.7e8);
  // A line contact hardens: a larger design force gives a larger stiffness.
  auto harder = contact;
  harder.design_force_n = 400;
  EXPECT_GT(hertz_stiffness_n_per_m(harder), stiffness);
}

TEST(HertzLine, PapersHalfWidthIsSmallerAndItsStiffnessLowerByAFewPerCent) {
  const auto textbook = steel_on_brass();
  auto paper = textbook;
  paper.half_width = model::HertzHalfWidth::paper;
  EXPECT_NEAR(hertz_half_width_m(paper, 200), hertz_half_width_m(textbook, 200) / std::sqrt(2), 1e-18);
  const double change = hertz_stiffness_n_per_m(paper) / hertz_stiffness_n_per_m(textbook) - 1;
  EXPECT_LT(change, -0.035);
  EXPECT_GT(change, -0.06);
}

TEST(HertzLine, AHoleFitsMoreCloselyAndIsStiffer) {
  const double flat = hertz_stiffness_n_per_m(steel_on_brass(model::HertzShape::flat));
  EXPECT_GT(hertz_stiffness_n_per_m(steel_on_brass(model::HertzShape::hole, 6e-3)), flat);
  EXPECT_LT(hertz_stiffness_n_per_m(steel_on_brass(model::HertzShape::cylinder, 3e-3)), flat);
}

TEST(HertzLine, AContactWiderThanLongIsRefused) {
  auto contact = steel_on_brass();
  contact.length_m = 1e-4;
  contact.design_force_n = 1e4;
  EXPECT_THROW(hertz_stiffness_n_per_m(contact), ConfigError);
}

/// At the force limit the secant stiffness exceeds the design stiffness by the tolerated tenth.
TEST(HertzLine, TheForceLimitIsWhereTheSecantIsATenthStiffer) {
  using enum model::HertzShape;
  for (const auto shape : {cylinder, flat, hole}) {
    auto contact = steel_on_brass(shape, 6e-3);
    for (const double design_force_n : {20.0, 250.0, 1500.0}) {
      contact.design_force_n = design_force_n;
      const double limit_n = hertz_force_limit_n(contact);
      EXPECT_GT(limit_n, design_force_n);
      const double secant = limit_n / hertz_approach_m(contact, limit_n);
      EXPECT_NEAR(secant, 1.1 * hertz_stiffness_n_per_m(contact), 1e-9 * secant) << design_force_n;
    }
  }
}

}  // namespace
}  // namespace rubsweep::contact
