#include "rubsweep/core/model/disc_geometry.hpp"

#include <gtest/gtest.h>

namespace rubsweep::model {
namespace {

/// Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), example 5.9.1, first disc as printed
/// by ROSS: 0.07 m wide, 0.28 m in diameter on a shaft of 0.05 m.
TEST(DiscGeometry, GivesThePrintedDisc) {
  const DiscGeometry disc{
      .outer_diameter_m = 0.28, .inner_diameter_m = 0.05, .width_m = 0.07, .density_kg_per_m3 = 7810};
  EXPECT_NEAR(disc.mass_kg(), 32.58972765304033, 1e-12);
  EXPECT_NEAR(disc.polar_inertia_kg_m2(), 0.32956362089137037, 1e-14);
  EXPECT_NEAR(disc.diametral_inertia_kg_m2(), 0.17808928257067666, 1e-14);
}

}  // namespace
}  // namespace rubsweep::model
