#include "rubscope/overall_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::apps {
namespace {

using recording::MachineGroup;
using recording::Place;
using std::numbers::pi;

/// Forty turns at 50 Hz of a probe that measured 1X of 100 um, and a line at 1500 Hz beyond the band.
recording::Recording measured(int times, Place place) {
  recording::Recording made{.sampling_rate_hz = 8000};
  made.place = place;
  made.integration.times = times;
  for (int turn = 0; turn <= 40; ++turn) made.turn_begin_s.push_back(0.02 * turn);
  for (int k = 0; k < 40 * recording::samples_per_revolution; ++k)
    made.displacement_m.emplace_back(1e-4 * std::cos(2 * pi * k / recording::samples_per_revolution));
  recording::ProbeSignal probe{.column = "A"};
  for (int k = 0; k < 6400; ++k) {
    const double t = k / 8000.0;
    probe.values.push_back(1e-4 * std::pow(2 * pi * 50, times) * std::cos(2 * pi * 50 * t) +
                           1e-6 * std::pow(2 * pi * 1500, times) * std::cos(2 * pi * 1500 * t) + 5);
  }
  made.probes.push_back(probe);
  return made;
}

TEST(OverallValues, OfACasingAreThoseOfItsVelocityInABand) {
  const double velocity = 1e-4 * 2 * pi * 50 / std::sqrt(2.0);
  for (const int times : {0, 1, 2}) {
    const auto values = overall_values(measured(times, Place::casing));
    ASSERT_EQ(values.size(), 1U);
    EXPECT_NEAR(values[0].velocity_rms_m_per_s.value(), velocity, 5e-4 * velocity) << times;
    EXPECT_NEAR(values[0].peak_to_peak_m, 2e-4, 1e-12);
    EXPECT_EQ(values[0].acceleration_rms_m_per_s2.has_value(), times == 2);
  }
  const double slow = 1e-4 * std::pow(2 * pi * 50, 2), fast = 1e-6 * std::pow(2 * pi * 1500, 2);
  EXPECT_NEAR(overall_values(measured(2, Place::casing))[0].acceleration_rms_m_per_s2.value(),
              std::hypot(slow, fast) / std::sqrt(2.0), 1e-3 * fast);
}

TEST(OverallValues, BandsAndZonesFollowSpeedAndMachine) {
  EXPECT_EQ(velocity_band(25).from_hz, 10);
  EXPECT_EQ(velocity_band(9.9).from_hz, 2);
  EXPECT_EQ(zone_of(2.3e-3, casing_limits(MachineGroup::large_rigid)), 'A');
  EXPECT_EQ(zone_of(7e-3, casing_limits(MachineGroup::large_flexible)), 'B');
  EXPECT_EQ(zone_of(7e-3, casing_limits(MachineGroup::medium_flexible)), 'C');
  EXPECT_EQ(zone_of(4.6e-3, casing_limits(MachineGroup::medium_rigid)), 'D');
  // 3600 rpm: 80, 150 and 220 um.
  const ZoneLimits limits = shaft_limits(60).value();
  EXPECT_NEAR(limits[0], 80e-6, 1e-12);
  EXPECT_NEAR(limits[2], 220e-6, 1e-12);
  EXPECT_FALSE(shaft_limits(9.9));
  EXPECT_FALSE(shaft_limits(501));
}

TEST(OverallValues, TextAndTableSayTheZone) {
  recording::Recording casing = measured(1, Place::casing);
  std::string text = overall_text(casing, overall_values(casing), {});
  EXPECT_NE(text.find("'A' 200 um peak to peak, 22.21 mm/s rms"), std::string::npos) << text;
  EXPECT_NE(text.find("zone D of ISO 20816-3, whatever the machine"), std::string::npos) << text;
  EXPECT_EQ(overall_csv(casing, overall_values(casing)).find("zone"), std::string::npos);
  for (double& value : casing.probes[0].values) value /= 7;
  text = overall_text(casing, overall_values(casing), {});
  EXPECT_NE(text.find("zone A to C of ISO 20816-3: machine_group"), std::string::npos) << text;
  casing.machine_group = MachineGroup::large_flexible;
  text = overall_text(casing, overall_values(casing), {});
  EXPECT_NE(text.find("zone A of ISO 20816-3: A to 3.5, B to 7.1, C to 11 mm/s rms"), std::string::npos)
      << text;
  EXPECT_NE(overall_csv(casing, overall_values(casing)).find("iso_20816_zone_a_to_m_per_s,0.0035,"),
            std::string::npos);
  const recording::Recording shaft = measured(0, Place::shaft);
  text = overall_text(shaft, overall_values(shaft), {});
  // 3000 rpm: 87.6, 164 and 241 um.
  EXPECT_NE(text.find("zone C of ISO 20816-3: A to 87.6, B to 164, C to 241 um peak to peak"),
            std::string::npos)
      << text;
  const recording::Recording absolute = measured(0, Place::shaft_absolute);
  EXPECT_EQ(overall_text(absolute, overall_values(absolute), {}).find("zone"), std::string::npos);
}

TEST(OverallValues, MissingReadingsLeaveNoRms) {
  recording::Recording casing = measured(2, Place::casing);
  casing.machine_group = MachineGroup::large_rigid;
  casing.probes[0].values[3000] = NAN;
  const auto values = overall_values(casing);
  EXPECT_FALSE(values[0].velocity_rms_m_per_s);
  EXPECT_FALSE(values[0].acceleration_rms_m_per_s2);
  EXPECT_NEAR(values[0].peak_to_peak_m, 2e-4, 1e-12);
  const std::string text = overall_text(casing, values, {});
  EXPECT_NE(text.find("no rms where readings are missing"), std::string::npos) << text;
  EXPECT_EQ(text.find("zone"), std::string::npos) << text;
  EXPECT_EQ(overall_csv(casing, values).find("rms"), std::string::npos);
}

TEST(OverallValues, LimitsOfTheDescriptionComeFirst) {
  recording::Recording casing = measured(1, Place::casing);
  casing.machine_group = MachineGroup::large_rigid;
  const auto values = overall_values(casing);
  casing.zone_limits_mm_per_s = {10, 20, 30};
  casing.zone_limits_um = {1, 2, 3};
  // 22.2 mm/s rms: zone D of the standard.
  EXPECT_NE(
      overall_text(casing, values, {}).find("zone C of the limits given: A to 10, B to 20, C to 30 mm/s rms"),
      std::string::npos);
  EXPECT_NE(overall_csv(casing, values).find("\nzone_b_to_m_per_s,0.02,"), std::string::npos);
  recording::Recording shaft = measured(0, Place::shaft);
  shaft.zone_limits_um = {50, 150, 250};
  EXPECT_NE(
      overall_text(shaft, overall_values(shaft), {}).find("zone C of the limits given: A to 50, B to 150"),
      std::string::npos);
}

}  // namespace
}  // namespace rubsweep::apps
