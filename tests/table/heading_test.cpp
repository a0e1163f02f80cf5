#include "rubsweep/table/heading.hpp"

#include <gtest/gtest.h>

namespace rubsweep::table {
namespace {

TEST(Heading, PartsNameAndUnit) {
  EXPECT_EQ(heading_of("Speed [rpm]").name, "Speed");
  EXPECT_EQ(heading_of("Speed [rpm]").unit, "rpm");
  EXPECT_EQ(heading_of("X (probe 2) (um)").name, "X (probe 2)");
  EXPECT_EQ(heading_of("t_s").unit, "");
  EXPECT_EQ(heading_of("odd)").name, "odd)");
}

TEST(Heading, UnitsAreOneInAnyWriting) {
  for (const char* written : {"N-s/m", "N s/m", "Ns/m", "N*s/m", "N.s/m", "N\u00b7s/m"})
    EXPECT_EQ(plain_unit(written), "Ns/m") << written;
  EXPECT_EQ(plain_unit("N/\u00b5m"), "N/um");
  EXPECT_EQ(plain_unit("N/\u03bcm"), "N/um");
}

TEST(Heading, KnowsUnits) {
  for (const char* unit :
       {"s", "ms", "\u00b5m", "Volts", "V", "lbf-s/in", "N/m", "RPM", "[anything]", "(m/s)", "-"})
    EXPECT_TRUE(is_unit(unit)) << unit;
  for (const char* name : {"X", "KP", "Time", "kxx", "", "()", "Rate=1000Hz"})
    EXPECT_FALSE(is_unit(name)) << name;
}

}  // namespace
}  // namespace rubsweep::table
