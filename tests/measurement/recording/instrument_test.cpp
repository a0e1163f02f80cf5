#include "rubsweep/measurement/recording/instrument.hpp"

#include <gtest/gtest.h>

#include <array>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::recording {
namespace {

std::string fault(const std::string& text) {
  try {
    read_instrument_text(text, "i.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

const std::string probe = "probes:\n  - {column: X, angle_deg: 45, gain_mv_per_um: -7.87}\n";

TEST(InstrumentRead, OneSourceOfTheSpeed) {
  EXPECT_NE(fault(probe + "speed: n\nspeed_hz: 30\n").find("exactly one of keyphasor, speed_hz, speed"),
            std::string::npos);
  EXPECT_NE(fault(probe + "speed: {unit: rpm}\n").find("i.yaml:3:8: speed"), std::string::npos);
  EXPECT_NE(fault(probe + "keyphasor: {column: K, pulses_per_turn: 0}\n").find("pulses_per_turn"),
            std::string::npos);
}

TEST(InstrumentRead, EverythingThatThereIs) {
  const auto instrument =
      read_instrument_text(probe +
                               "  - {column: Y, angle_deg: 135}\ntime: t\n"
                               "keyphasor: {column: KP, mark: bright, threshold: 2.5, hysteresis: 0.1}\n",
                           "i.yaml");
  ASSERT_EQ(instrument.probes.size(), 2u);
  EXPECT_EQ(instrument.probes[0].column, "X");
  EXPECT_EQ(instrument.probes[0].gain_mv_per_um, -7.87);
  EXPECT_EQ(instrument.probes[1].angle_deg, 135);
  EXPECT_FALSE(instrument.probes[1].gain_mv_per_um);
  EXPECT_EQ(instrument.time, "t");
  ASSERT_TRUE(instrument.keyphasor);
  EXPECT_EQ(instrument.keyphasor->mark, rubsweep::recording::Mark::bright);
  EXPECT_EQ(instrument.keyphasor->threshold, 2.5);
  EXPECT_EQ(instrument.keyphasor->hysteresis, 0.1);
  const auto wheel = read_instrument_text(
      probe + "sampling_rate_hz: 1\nkeyphasor: {column: K, pulses_per_turn: 60}\n", "i.yaml");
  EXPECT_EQ(wheel.keyphasor->pulses_per_turn, 60);
  EXPECT_EQ(read_instrument_text(probe + "speed: n\n", "i.yaml").speed->column, "n");
  EXPECT_EQ(read_instrument_text(probe + "speed: {column: n, unit: rpm}\n", "i.yaml").speed->unit, "rpm");
  const auto recorder = read_instrument_text(
      "probes:\n  - {column: channel 1, angle_deg: 0, gain_mv_per_um: 8, unit: FS, range_v: 10}\n"
      "keyphasor: {column: channel 2}\nrun_out: {from_s: 0, to_s: 3, subtract: vector}\n",
      "i.yaml");
  EXPECT_EQ(recorder.probes[0].unit, "FS");
  EXPECT_EQ(recorder.probes[0].range_v, 10);
  ASSERT_TRUE(recorder.run_out);
  EXPECT_EQ(recorder.run_out->to_s, 3);
  EXPECT_TRUE(recorder.run_out->vector);
  const auto from_rest = read_instrument_text(
      "probes:\n  - {column: A, angle_deg: 0, rest: -9.1}\n  - {column: B, angle_deg: 90, rest: 0}\n"
      "keyphasor: {column: K}\n",
      "i.yaml");
  EXPECT_EQ(from_rest.probes[0].rest, -9.1);
  EXPECT_EQ(from_rest.probes[1].rest, 0);
  EXPECT_FALSE(recorder.probes[0].rest);
  const auto casing = read_instrument_text(
      "probes: [{column: A, angle_deg: 0, gain_mv_per_g: 100, on: casing}]\nkeyphasor: {column: K}\n"
      "lowest_order: 0.4\nmachine_group: medium_rigid\nzone_limits_mm_per_s: [2, 4, 8]\nzone_limits_um: [50, "
      "90, 120]\n",
      "i.yaml");
  EXPECT_EQ(casing.probes[0].gain_mv_per_g, 100);
  EXPECT_EQ(casing.probes[0].on, rubsweep::recording::Place::casing);
  EXPECT_EQ(casing.lowest_order, 0.4);
  EXPECT_EQ(casing.zone_limits_mm_per_s, (std::array{2.0, 4.0, 8.0}));
  EXPECT_EQ(casing.zone_limits_um, (std::array{50.0, 90.0, 120.0}));
  const auto swept = read_instrument_text(probe + "sweep: {from_hz: 12, to_hz: 58}\n", "i.yaml");
  ASSERT_TRUE(swept.sweep);
  EXPECT_EQ(swept.sweep->to_hz, 58);
  EXPECT_EQ(casing.machine_group, rubsweep::recording::MachineGroup::medium_rigid);
  const auto without =
      read_instrument_text(probe + "sampling_rate_hz: 5000\nspeed_hz: 70\nfrom_s: 1\nto_s: 2.5\n", "i.yaml");
  EXPECT_EQ(without.sampling_rate_hz, 5000);
  EXPECT_EQ(without.speed_hz, 70);
  EXPECT_EQ(without.from_s, 1);
  EXPECT_EQ(without.to_s, 2.5);
}

TEST(InstrumentRead, WrongOnesAreNamedWithTheirPlace) {
  const std::string clock = "time: t\nspeed_hz: 70\n";
  EXPECT_NE(fault(clock).find("probes"), std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle_deg: 0, rest: 1}\n  - {column: Y, angle_deg: 90}\n")
                .find("have a reading at rest of one alone"),
            std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle: 3}\n").find("i.yaml:4:17: probes.0.angle"),
            std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle: 3}\n").find("angle_deg"), std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle_deg: 3, gain_mv_per_um: 0}\n").find("is 0"),
            std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle_deg: 3, gain_mv_per_g: 1, gain_mv_per_um: 8}\n")
                .find("is there beside another gain, allowed: one"),
            std::string::npos);
  EXPECT_NE(fault(clock + "probes:\n  - {column: X, angle_deg: 3, on: floor}\n").find("shaft_absolute"),
            std::string::npos);
  EXPECT_NE(fault(probe + "time: t\nsweep: {from_hz: 0, to_hz: 5}\n").find("sweep.from_hz"),
            std::string::npos);
  EXPECT_NE(fault(clock + probe + "sweep: {from_hz: 1, to_hz: 5}\n").find("sweep"), std::string::npos);
  EXPECT_NE(fault(clock + probe + "lowest_order: 0\n").find("lowest_order"), std::string::npos);
  for (const char* limits : {"[2, 2, 4]", "[0, 2, 4]", "[4, 2, 1]"})
    EXPECT_NE(
        fault(clock + probe + "zone_limits_um: " + limits + "\n").find("zone_limits_um: holds no limits of"),
        std::string::npos);
  EXPECT_NE(fault(clock + probe + "zone_limits_mm_per_s: [2, 4]\n").find("a list of 3 numbers"),
            std::string::npos);
  EXPECT_NE(fault(clock + probe + "  - {column: Y, angle_deg: 230}\n").find("look along one line"),
            std::string::npos);
  EXPECT_EQ(fault(probe + "speed_hz: 70\n"), "none");  // a WAV file contains its sampling rate
  EXPECT_NE(fault(clock + probe + "run_out: {from_s: 1, to_s: 2}\n").find("with keyphasor"),
            std::string::npos);
  EXPECT_NE(fault(probe + "time: t\nkeyphasor: {column: K}\nrun_out: {from_s: 1, subtract: x}\n")
                .find("run_out.to_s"),
            std::string::npos);
  EXPECT_NE(fault(probe + clock + "sampling_rate_hz: 5\n").find("sampling_rate_hz"), std::string::npos);
  EXPECT_NE(fault(probe + "time: t\nspeed_hz: -1\n").find("i.yaml:4:11: speed_hz"), std::string::npos);
  EXPECT_NE(fault(probe + "time: t\nkeyphasor: {column: K, mark: blank}\n").find("dark, bright"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::recording
