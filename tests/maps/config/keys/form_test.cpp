#include "rubsweep/maps/config/keys/form.hpp"

#include <gtest/gtest.h>

namespace rubsweep::config::keys {
namespace {

TEST(Form, SaysWhatIsAllowed) {
  EXPECT_EQ(allowed(number({})), "a number");
  EXPECT_EQ(allowed(number({.low = 0, .high = 1, .low_open = true})), "> 0 and <= 1");
  EXPECT_EQ(allowed(number({.high = 2, .high_open = true})), "< 2");
  EXPECT_EQ(allowed(even_integer(4, 4096)), "even integer, 4 to 4096");
  EXPECT_EQ(allowed(word({"one_side", "annular"})), "one_side or annular");
  EXPECT_EQ(allowed(list_of(number({}), 6, 6)), "list of 6, each: a number");
  EXPECT_EQ(allowed(list_of(map_of({}), 1, 16)), "list of 1 to 16 maps");
  EXPECT_EQ(allowed(numbered(map_of({}), 16)), "map from numbers, 0 to 15");
  EXPECT_EQ(allowed(any_of({word({"rigid"}), map_of({}), map_of({})})), "rigid, or a map");
  EXPECT_EQ(allowed(any_of({map_of({}), map_of({})})), "map");
  EXPECT_EQ(allowed(any_of({word({"auto"}), integer(1, 40)})), "auto, or an integer from 1 to 40");
  EXPECT_EQ(allowed(any_of({number({}), list_of(number({}), 1, 9)})),
            "a number, or a list of 1 to 9 such numbers");
  EXPECT_EQ(allowed(any_of({text(80), map_of({})})), "a text of at most 80 bytes, or a map");
}

TEST(Form, NewerKeysSaySo) {
  EXPECT_EQ(must("a", text(), "").since, "0.1.0");
  EXPECT_EQ(newer({must("a", text(), "")})[0].since, "0.2.0");
}

TEST(FormUnitOf, IsTheEndOfTheName) {
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

TEST(FormUnitOf, IsEmptyWithoutOne) {
  EXPECT_EQ(unit_of("restitution"), "");
  EXPECT_EQ(unit_of("count"), "");
  EXPECT_EQ(unit_of("m"), "");
}

}  // namespace
}  // namespace rubsweep::config::keys
