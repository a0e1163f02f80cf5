#include "rubsweep/measurement/recording/channels.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

Probe probe(std::optional<double> gain, std::optional<double> range_v = {}) {
  return {.column = "x", .gain_mv_per_um = gain, .range_v = range_v};
}

TEST(ChannelsUnit, OfTimesAndProbes) {
  EXPECT_EQ(seconds_per("", "t", "f"), 1);
  EXPECT_EQ(seconds_per("ms", "t", "f"), 1e-3);
  EXPECT_EQ(scale_of("mil", probe({}), "f").si_per_unit, 25.4e-6);
  EXPECT_EQ(scale_of("\u00b5m", probe({}), "f").si_per_unit, scale_of("\u03bcm", probe({}), "f").si_per_unit);
  EXPECT_EQ(scale_of("in", probe({}), "f").si_per_unit, 0.0254);
  EXPECT_EQ(scale_of("mils", probe({}), "f").si_per_unit, 25.4e-6);
  // 200 mV/mil are 7.874 mV/um.
  EXPECT_NEAR(scale_of("V", probe(200 / 25.4), "f").si_per_unit, 5 * 25.4e-6, 1e-15);
  EXPECT_EQ(scale_of("mV", probe(-8), "f").si_per_unit, -0.125e-6);
  Probe said = probe({});
  said.unit = "um";
  EXPECT_EQ(scale_of("", said, "f").si_per_unit, 1e-6);
}

TEST(ChannelsUnit, ARangeSaysWhereReadingsAreCutOff) {
  EXPECT_EQ(scale_of("V", probe(8, 10), "f").full_scale, 10);
  EXPECT_EQ(scale_of("mV", probe(8, 10), "f").full_scale, 10000);
  const Scale shares = scale_of("FS", probe(8, 10), "f");
  EXPECT_EQ(shares.full_scale, 1);
  // Full scale of 10 V at 8 mV/um.
  EXPECT_NEAR(shares.si_per_unit, 1.25e-3, 1e-15);
  EXPECT_FALSE(scale_of("V", probe(8), "f").full_scale);
}

TEST(ChannelsUnit, OfVelocityAndAccelerationAreKnown) {
  using table::Quantity;
  const auto is = [](const Scale& scale, Quantity quantity, double si) {
    EXPECT_EQ(scale.quantity, quantity);
    EXPECT_NEAR(scale.si_per_unit, si, 1e-12 * si);
  };
  is(scale_of("mm/s", probe({}), "f"), Quantity::velocity, 1e-3);
  is(scale_of("in/s", probe({}), "f"), Quantity::velocity, 0.0254);
  is(scale_of("IPS", probe({}), "f"), Quantity::velocity, 0.0254);
  is(scale_of("m/s\u00b2", probe({}), "f"), Quantity::acceleration, 1);
  is(scale_of("m/s^2", probe({}), "f"), Quantity::acceleration, 1);
  is(scale_of("G's", probe({}), "f"), Quantity::acceleration, 9.80665);
  Probe accelerometer = probe({});
  accelerometer.gain_mv_per_g = 100;
  is(scale_of("V", accelerometer, "f"), Quantity::acceleration, 98.0665);
  Probe seismometer = probe({});
  seismometer.gain_mv_per_mm_per_s = 4;
  is(scale_of("mV", seismometer, "f"), Quantity::velocity, 2.5e-4);
}

TEST(ChannelsUnit, WrongOnesAreNamed) {
  const auto message = [](const char* unit, std::optional<double> gain) {
    try {
      scale_of(unit, probe(gain), "f.csv");
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(message("V", {}),
            "f.csv: 'x': is in V and has no gain, allowed: a gain_mv_per_um, gain_mv_per_mm_per_s or "
            "gain_mv_per_g");
  EXPECT_EQ(message("FS", 8),
            "f.csv: 'x': is in shares of the full scale and has no range, allowed: a range_v");
  EXPECT_EQ(message("um", 8), "f.csv: 'x': is in um and has a gain_mv_per_um, allowed: no gain");
  EXPECT_TRUE(message("bar", {}).starts_with(
      "f.csv: 'x': the unit 'bar' is unknown, allowed: m, mm, um, mil, V or mV"));
  EXPECT_TRUE(message("", {}).starts_with("f.csv: 'x': has no unit"));
  EXPECT_THROW(seconds_per("um", "t", "f"), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
