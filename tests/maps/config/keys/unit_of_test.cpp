#include "rubsweep/maps/config/keys/unit_of.hpp"

#include <gtest/gtest.h>

namespace rubsweep::config::keys {
namespace {

TEST(UnitOf, IsTheEndOfTheName) {
  EXPECT_EQ(unit_of("stiffness_n_per_m"), "N/m");
  EXPECT_EQ(unit_of("damping_ns_per_m"), "N s/m");
  EXPECT_EQ(unit_of("angular_stiffness_nm_per_rad"), "N m/rad");
  EXPECT_EQ(unit_of("drive_damping_nms_per_rad"), "N m s/rad");
  EXPECT_EQ(unit_of("density_kg_per_m3"), "kg/m3");
  EXPECT_EQ(unit_of("viscous_s_per_m"), "s/m");
  EXPECT_EQ(unit_of("gravity_m_per_s2"), "m/s2");
  EXPECT_EQ(unit_of("unbalance_g_mm"), "g mm");
  EXPECT_EQ(unit_of("balance_grade_mm_per_s"), "mm/s");
  EXPECT_EQ(unit_of("clearance_m"), "m");
}

TEST(UnitOf, IsEmptyWithoutOne) {
  EXPECT_EQ(unit_of("restitution"), "");
  EXPECT_EQ(unit_of("count"), "");
  EXPECT_EQ(unit_of("m"), "");
}

}  // namespace
}  // namespace rubsweep::config::keys
