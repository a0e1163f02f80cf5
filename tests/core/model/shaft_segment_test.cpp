#include "rubsweep/core/model/shaft_segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rubsweep::model {
namespace {

using std::numbers::pi;

ShaftSegment cone() {
  return {{.outer_diameter_m = 0.1,
           .inner_diameter_m = 0.02,
           .outer_diameter_end_m = 0.06,
           .youngs_modulus_pa = 2e11,
           .shear_modulus_pa = 8e10,
           .density_kg_per_m3 = 7800},
          0.3};
}

TEST(ShaftSegment, ATaperWeighsWhatAFrustumWeighs) {
  const double frustum = pi * 0.3 / 12 * (0.1 * 0.1 + 0.1 * 0.06 + 0.06 * 0.06),
               bore = pi / 4 * 0.02 * 0.02 * 0.3;
  EXPECT_NEAR(mass_kg(cone()), 7800 * (frustum - bore), 1e-12);
}

TEST(ShaftSegment, LayersAddTheirMass) {
  ShaftSegment segment = cone();
  const double alone = mass_kg(segment);
  segment.layers.push_back({.outer_diameter_m = 0.2,
                            .inner_diameter_m = 0.1,
                            .youngs_modulus_pa = 1e4,
                            .shear_modulus_pa = 1e4,
                            .density_kg_per_m3 = 1000});
  EXPECT_NEAR(mass_kg(segment) - alone, 1000 * pi / 4 * 0.03 * 0.3, 1e-12);
}

TEST(ShaftSegment, DiametersChangeLinearly) {
  EXPECT_DOUBLE_EQ(diameters(cone(), 0.25).outer_m, 0.09);
  EXPECT_DOUBLE_EQ(diameters(cone(), 0.25).inner_m, 0.02);
}

std::string blamed(const ShaftLayer& layer) {
  const auto problem = diameter_problem(layer);
  return problem ? problem->key : "nothing";
}

TEST(ShaftSegment, DiametersThatLeaveNoWallAreAProblem) {
  EXPECT_EQ(blamed(cone()), "nothing");
  ShaftSegment segment = cone();
  segment.inner_diameter_m = 0.1;
  EXPECT_EQ(blamed(segment), "inner_diameter_m");
  segment = cone();
  segment.inner_diameter_end_m = 0.07;
  EXPECT_EQ(blamed(segment), "inner_diameter_end_m");
  segment = cone();
  segment.outer_diameter_end_m = 0.01;
  EXPECT_EQ(blamed(segment), "outer_diameter_end_m");
  segment = cone();
  segment.stiffness_outer_diameter_m = 0.09;
  EXPECT_EQ(blamed(segment), "stiffness_outer_diameter_m");
  segment.outer_diameter_end_m.reset();
  EXPECT_EQ(blamed(segment), "nothing");
  segment.stiffness_inner_diameter_m = 0.09;
  EXPECT_EQ(blamed(segment), "stiffness_inner_diameter_m");
}

}  // namespace
}  // namespace rubsweep::model
