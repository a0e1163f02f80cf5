#include "rubsweep/measurement/recording/speed_column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measurement/recording/shaft_marks.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

constexpr SampleClock speed_clock{2, 1000};

/// A speed of f + r t turns a second. The unit of the column is `size` turns a second.
Channels with_speed(double f, double r, double size, const char* unit, std::size_t count = 3000) {
  Channels channels;
  channels.channels = {{"n", unit, {}}};
  for (std::size_t k = 0; k < count; ++k)
    channels.channels[0].values.push_back((f + r * static_cast<double>(k) / speed_clock.rate_hz) / size);
  return channels;
}

std::string speed_fault(const Channels& channels, const SpeedColumn& speed) {
  try {
    turns_by_speed(channels, speed, speed_clock, "f.csv");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(SpeedColumn, TurnsAreItsIntegral) {
  for (const double r : {0.0, 4.0, -3.0}) {
    const auto begins = turns_by_speed(with_speed(20, r, 1.0 / 60, "rpm"), {"n"}, speed_clock, "f");
    ASSERT_GT(begins.size(), 40u);
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const double turns = static_cast<double>(k);
      EXPECT_NEAR(begins[k], 2 + 2 * turns / (20 + std::sqrt(400 + 2 * r * turns)), 1e-9) << r << ' ' << k;
    }
  }
}

TEST(SpeedColumn, UnitsAndFactor) {
  const auto hertz = turns_by_speed(with_speed(25, 0, 1, "Hz"), {"n"}, speed_clock, "f");
  EXPECT_NEAR(hertz[50], 4, 1e-9);
  const auto radians =
      turns_by_speed(with_speed(25, 0, 0.5 / std::numbers::pi, ""), {"n", "rad/s"}, speed_clock, "f");
  EXPECT_NEAR(radians[50], 4, 1e-9);
  const auto faster = turns_by_speed(with_speed(25, 0, 1, "Hz"), {"n", {}, 1.25}, speed_clock, "f");
  EXPECT_NEAR(faster[50], 2 + 50 / 31.25, 1e-9);
  EXPECT_NE(speed_fault(with_speed(25, 0, 1, "mm"), {"n"})
                .find("the unit 'mm' is none of a speed, allowed: Hz, rpm"),
            std::string::npos);
  EXPECT_NE(speed_fault(with_speed(-1, 0, 1, "Hz"), {"n"}).find("allowed: speeds of 0 and more"),
            std::string::npos);
  EXPECT_NE(speed_fault(with_speed(600, 0, 1, "Hz"), {"n"}).find("fewer than two readings a turn"),
            std::string::npos);
}

TEST(SpeedColumn, GapsAreBridged) {
  auto channels = with_speed(20, 0, 1, "Hz");
  for (const std::size_t k : {0u, 1u, 700u, 701u, 702u, 2999u}) channels.channels[0].values[k] = NAN;
  const auto begins = turns_by_speed(channels, {"n"}, speed_clock, "f");
  EXPECT_NEAR(begins[40], 4, 1e-9);
  for (double& value : channels.channels[0].values) value = NAN;
  EXPECT_NE(speed_fault(channels, {"n"}).find("has no number"), std::string::npos);
}

TEST(SpeedColumn, TheSignalSaysHowFarItIsOff) {
  std::vector<double> x;
  for (int k = 0; k < 3000; ++k) x.push_back(1e-4 * std::cos(2 * std::numbers::pi * 20.01 * k / 1000));
  std::vector<std::string> findings;
  const auto begins = turns_by_speed(with_speed(20, 0, 1, "Hz"), {"n"}, speed_clock, "f");
  const auto factor = speed_factor({x}, speed_clock, begins, findings);
  ASSERT_TRUE(factor);
  EXPECT_NEAR(*factor, 1.0005, 1e-6);
  EXPECT_EQ(findings.size(), 1u);
  // A run-up has no line from which the factor could be found.
  EXPECT_FALSE(speed_factor({x}, speed_clock,
                            turns_by_speed(with_speed(20, 4, 1, "Hz"), {"n"}, speed_clock, "f"), findings));
}

}  // namespace
}  // namespace rubsweep::recording
