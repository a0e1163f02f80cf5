#include "rubsweep/maps/table/unit.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rubsweep::table {
namespace {

void expect_unit(std::string_view words, Quantity quantity, double in_si) {
  const auto unit = unit_of(words);
  ASSERT_TRUE(unit) << words;
  EXPECT_EQ(unit->quantity, quantity) << words;
  EXPECT_NEAR(unit->in_si, in_si, 1e-9 * in_si) << words;
}

TEST(Unit, UnitsOfSuppliersHaveTheirSizes) {
  expect_unit("lbf/in", Quantity::stiffness, 175.12683524);
  expect_unit("lbf-s/in", Quantity::damping, 175.12683524);
  expect_unit("lbf s^2/in", Quantity::mass, 175.12683524);
  expect_unit("N/mm", Quantity::stiffness, 1e3);
  expect_unit("N/\u00b5m", Quantity::stiffness, 1e6);
  expect_unit("MN/m", Quantity::stiffness, 1e6);
  expect_unit("kN/mm", Quantity::stiffness, 1e6);
  expect_unit("N\u00b7s/m", Quantity::damping, 1);
  expect_unit("rad/s", Quantity::turning, 0.5 / std::numbers::pi);
  expect_unit("RPM", Quantity::turning, 1.0 / 60);
  expect_unit("mil", Quantity::length, 25.4e-6);
  expect_unit("in/s", Quantity::velocity, 0.0254);
  expect_unit("g", Quantity::acceleration, 9.80665);
  expect_unit("m/s^2", Quantity::acceleration, 1);
  expect_unit("psi", Quantity::pressure, 6894.757293);
}

TEST(Unit, CapitalsCountWhereMilliAndMegaDiffer) {
  EXPECT_FALSE(unit_of("mN/m"));
  EXPECT_FALSE(unit_of("mN"));
  EXPECT_FALSE(unit_of("MV"));
  expect_unit("Hz", Quantity::turning, 1);
  expect_unit("n/m", Quantity::stiffness, 1);
}

TEST(Unit, WordsThatAreNoneAreNone) {
  for (const char* words : {"", "speed", "kxx", "N m", "1"}) EXPECT_FALSE(unit_of(words)) << words;
}

}  // namespace
}  // namespace rubsweep::table
