#include "rubsweep/recording/unit.hpp"

#include <gtest/gtest.h>

#include "rubsweep/error.hpp"

namespace rubsweep::recording {
namespace {

TEST(Unit, OfTimesAndProbes) {
  EXPECT_EQ(seconds_per("", "t", "f"), 1);
  EXPECT_EQ(seconds_per("ms", "t", "f"), 1e-3);
  EXPECT_EQ(metres_per("mil", "x", {}, "f"), 25.4e-6);
  EXPECT_EQ(metres_per("\u00b5m", "x", {}, "f"), metres_per("\u03bcm", "x", {}, "f"));
  // 200 mV/mil are 7.874 mV/um.
  EXPECT_NEAR(metres_per("V", "x", 200 / 25.4, "f"), 5 * 25.4e-6, 1e-15);
  EXPECT_EQ(metres_per("mV", "x", -8, "f"), -0.125e-6);
}

TEST(Unit, WrongOnesAreNamed) {
  const auto message = [](const char* unit, std::optional<double> gain) {
    try {
      metres_per(unit, "x", gain, "f.csv");
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(message("V", {}), "f.csv: 'x': is in V and has no gain, allowed: a gain_mv_per_um");
  EXPECT_EQ(message("um", 8), "f.csv: 'x': is in um and has a gain_mv_per_um, allowed: no gain");
  EXPECT_EQ(message("g", {}),
            "f.csv: 'x': the unit 'g' is unknown, allowed: m, mm, um, mil, and V or mV with a "
            "gain_mv_per_um");
  EXPECT_TRUE(message("", {}).starts_with("f.csv: 'x': has no unit"));
  EXPECT_THROW(seconds_per("um", "t", "f"), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
