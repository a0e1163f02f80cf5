#include "rubsweep/measurement/recording/recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// An elliptic motion at 40 Hz, read at 4 kHz by probes at 45 and 135 degrees in mV (8 mV/um) with a gap
/// voltage, and a keyway in every turn.
Channels ellipse() {
  Channels channels;
  channels.channels = {{"t", "ms", {}}, {"A", "mV", {}}, {"B", "mV", {}}, {"KP", "V", {}}};
  for (std::size_t k = 0; k < 4000; ++k) {
    const double t = static_cast<double>(k) / 4000, turns = 40 * t;
    const Complex z =
        50e-6 * std::polar(1.0, 2 * pi * turns) + 10e-6 * std::polar(1.0, -2 * pi * turns + 0.3);
    const auto read = [&](double angle) { return 8e6 * (z * std::polar(1.0, -angle)).real() - 9000; };
    const double values[] = {1e3 * t, read(pi / 4), read(3 * pi / 4), k % 100 < 10 ? -14.0 : -6.0};
    for (std::size_t i = 0; i < 4; ++i) channels.channels[i].values.push_back(values[i]);
    channels.line.push_back(k + 3);
  }
  return channels;
}

const Instrument two_probes{
    .time = "t", .probes = {{"A", 45, 8.0}, {"B", 135, 8.0}}, .keyphasor = Keyphasor{.column = "KP"}};

std::string recording_fault(const Channels& channels, const Instrument& instrument) {
  try {
    make_recording(channels, instrument, "f.csv");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Recording, IsTheMotionAtEqualAngles) {
  const Recording recording = make_recording(ellipse(), two_probes, "f.csv");
  EXPECT_NEAR(recording.sampling_rate_hz, 4000, 1e-6);
  EXPECT_EQ(recording.findings, std::vector<std::string>{});
  ASSERT_EQ(recording.turns(), 38);
  // The edge lies half a sample before the first reading of the keyway: 0.5 % of a turn.
  const double early = -0.005;
  const Complex gap = -9000 / 8e6 * Complex(0, std::sqrt(2.0));
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double turns = early + static_cast<double>(k) / samples_per_revolution;
    const Complex expected =
        50e-6 * std::polar(1.0, 2 * pi * turns) + 10e-6 * std::polar(1.0, -2 * pi * turns + 0.3) + gap;
    ASSERT_LT(std::abs(recording.displacement_m[k] - expected), 1e-9) << k;
  }
}

TEST(Recording, CountsFromTheReadingsAtRest) {
  Instrument instrument = two_probes;
  const Recording as_read = make_recording(ellipse(), instrument, "f.csv");
  EXPECT_FALSE(as_read.from_rest);
  // At 8 mV/um the rotor rests 25 um closer to the first probe and 50 um away from the second one.
  instrument.probes[0].rest = -8800;
  instrument.probes[1].rest = -9400;
  const Recording from_rest = make_recording(ellipse(), instrument, "f.csv");
  EXPECT_TRUE(from_rest.from_rest);
  Complex mean = 0;
  for (const Complex z : from_rest.displacement_m) mean += z;
  mean /= static_cast<double>(from_rest.displacement_m.size());
  const Complex expected = -25e-6 * std::polar(1.0, pi / 4) + 50e-6 * std::polar(1.0, 3 * pi / 4);
  EXPECT_LT(std::abs(mean - expected), 1e-9);
}

TEST(Recording, ASpeedStandsInForTheKeyphasorAndARateForTimes) {
  Instrument instrument = two_probes;
  instrument.keyphasor.reset();
  instrument.speed_hz = 40;
  instrument.time.reset();
  instrument.sampling_rate_hz = 4000;
  instrument.probes.resize(1);
  const Recording recording = make_recording(ellipse(), instrument, "f.csv");
  EXPECT_EQ(recording.turns(), 39);
  EXPECT_FALSE(recording.plane);
  EXPECT_EQ(recording.displacement_m.front().imag(), 0);
}

/// A wheel with five teeth. In one turn the pulse of one tooth is missing, and noise makes an additional
/// pulse.
TEST(Recording, PulsesAreCountedToTurns) {
  Channels channels = ellipse();
  std::vector<double>& wheel = channels.channels[3].values;
  for (std::size_t k = 0; k < wheel.size(); ++k) wheel[k] = k % 20 < 4 ? -14.0 : -6.0;
  for (std::size_t k = 1220; k < 1230; ++k) wheel[k] = -6;
  wheel[1711] = wheel[1712] = -14;
  Instrument instrument = two_probes;
  instrument.keyphasor->pulses_per_turn = 5;
  const Recording counted = make_recording(channels, instrument, "f.csv");
  EXPECT_NEAR(counted.mean_speed_hz(), 40, 1e-6);
  ASSERT_EQ(counted.findings.size(), 3u);
  EXPECT_NE(counted.findings[0].find("has no mark in 1 steps"), std::string::npos) << counted.findings[0];
  EXPECT_NE(counted.findings[1].find("has 1 marks too many"), std::string::npos) << counted.findings[1];
  const auto& turns = counted.turn_begin_s;
  for (std::size_t k = 1; k < turns.size(); ++k) EXPECT_NEAR(turns[k] - turns[k - 1], 0.025, 1e-4) << k;
}

TEST(Recording, AColumnOfTheSpeedStandsInForTheKeyphasor) {
  Channels channels = ellipse();
  channels.channels[3] = {"n", "rpm", std::vector<double>(4000, 2401)};
  Instrument instrument = two_probes;
  instrument.keyphasor.reset();
  instrument.speed = SpeedColumn{.column = "n"};
  const Recording recording = make_recording(channels, instrument, "f.csv");
  EXPECT_NEAR(recording.mean_speed_hz(), 40, 1e-3);
  ASSERT_EQ(recording.findings.size(), 1u);
  EXPECT_NE(recording.findings[0].find("times that of its column"), std::string::npos);
  EXPECT_GT(recording.angle_doubt.degree, 0);
}

TEST(Recording, AStretchOfIt) {
  Instrument instrument = two_probes;
  instrument.from_s = 0.2;
  instrument.to_s = 0.4;
  const Recording recording = make_recording(ellipse(), instrument, "f.csv");
  EXPECT_GE(recording.turn_begin_s.front(), 0.2);
  EXPECT_LE(recording.turn_begin_s.back(), 0.4);
  EXPECT_EQ(recording.turns(), 7);
}

TEST(Recording, NamesWhatIsWrong) {
  Channels channels = ellipse();
  auto& a = channels.channels[1].values;
  a[700] = NAN;
  for (double& value : a)
    if (value > -8700) value = -8700;
  channels.channels[2].values.assign(a.size(), -9000.0);
  const Recording recording = make_recording(channels, two_probes, "f.csv");
  EXPECT_EQ(recording.findings, (std::vector<std::string>{
                                    "'A' has gaps: 1 readings are missing, the first one in line 703",
                                    "'A' is clipped above", "'B' is dead: it reads one value all the time"}));
  // Turn 7 contains reading 700; the part after it is longer than the part before.
  EXPECT_EQ(recording.turns(), 31);
}

TEST(Recording, OfATimeThatJumpsTheLongestStretchIsLookedAt) {
  Channels jumps = ellipse();
  for (std::size_t k = 2500; k < 4000; ++k) jumps.channels[0].values[k] += 3;
  const Recording recording = make_recording(jumps, two_probes, "f.csv");
  EXPECT_EQ(
      recording.findings,
      (std::vector<std::string>{"'t' jumps from 624.75 to 628 at line 2503: the longest stretch without a "
                                "jump, from 0 to 624.75, is looked at"}));
  EXPECT_NEAR(recording.mean_speed_hz(), 40, 1e-9);
  EXPECT_LT(recording.turn_begin_s.back(), 0.625);
}

TEST(Recording, RefusesWhatCannotBeUsed) {
  Channels steps_back = ellipse();
  for (std::size_t k = 2000; k < 4000; ++k) steps_back.channels[0].values[k] -= 3;
  EXPECT_EQ(recording_fault(steps_back, two_probes),
            "f.csv:2003: 't' goes from 499.75 to 497, allowed: a step of 0.25 as elsewhere");
  Channels drifts = ellipse();
  for (std::size_t k = 2000; k < 4000; ++k)
    drifts.channels[0].values[k] -= 0.05 * static_cast<double>(k - 2000);  // steps of 0.2 instead of 0.25
  EXPECT_NE(recording_fault(drifts, two_probes).find("steps off its place, allowed: an even sampling rate"),
            std::string::npos);
  Instrument misspelt = two_probes;
  misspelt.probes[1].column = "C";
  EXPECT_EQ(recording_fault(ellipse(), misspelt), "f.csv: has no column 'C', allowed: 't', 'A', 'B', 'KP'");
  Channels stuck = ellipse();
  stuck.channels[3].values.assign(4000, -6.0);
  EXPECT_EQ(recording_fault(stuck, two_probes),
            "f.csv: 'KP': the keyphasor's signal does not change, "
            "allowed: one that a mark changes every turn");
  Instrument slow = two_probes;
  slow.keyphasor.reset();
  slow.speed_hz = 1e12;
  EXPECT_EQ(recording_fault(ellipse(), slow),
            "f.csv: has fewer than two readings a turn at speed_hz, allowed: up to half the sampling rate");
  slow.speed_hz = 2;
  EXPECT_EQ(recording_fault(ellipse(), slow), "f.csv: holds 1 whole turns of the shaft, allowed: 4 or more");
}

TEST(Recording, OfASweepNeedsTurns) {
  Instrument instrument = two_probes;
  instrument.keyphasor.reset();
  instrument.sweep = Sweep{12, 58};
  EXPECT_EQ(recording_fault(ellipse(), instrument),
            "f.csv: has a sweep in its description, allowed: a mark or a steady speed");
  FollowedTurns turns;
  turns.finding = "followed";
  for (int turn = 0; turn < 39; ++turn) turns.begin_s.push_back(0.025 * turn);
  const Recording recording = make_recording(ellipse(), instrument, "f.csv", &turns);
  EXPECT_FALSE(recording.phased);
  EXPECT_EQ(recording.turns(), 38);
  EXPECT_EQ(recording.findings, std::vector<std::string>{"followed"});
}

}  // namespace
}  // namespace rubsweep::recording
