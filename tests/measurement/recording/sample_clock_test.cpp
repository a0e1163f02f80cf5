#include "rubsweep/measurement/recording/sample_clock.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

Channels table() {
  Channels channels;
  channels.channels = {{"t", "ms", {}}, {"x", "um", {}}};
  for (int k = 0; k < 100; ++k) {
    channels.channels[0].values.push_back(5 + 0.5 * k);
    channels.channels[1].values.push_back(k);
  }
  return channels;
}

std::string clock_fault(const Channels& channels, const Instrument& instrument) {
  try {
    clock_of(channels, instrument, "f.csv");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SampleClock, TimesOfAColumnARateOrTheFile) {
  const SampleClock column = clock_of(table(), {.time = "t"}, "f.csv");
  EXPECT_NEAR(column.first_s, 5e-3, 1e-15);
  EXPECT_NEAR(column.rate_hz, 2000, 1e-9);
  EXPECT_EQ(clock_of(table(), {.sampling_rate_hz = 50}, "f.csv").rate_hz, 50);
  Channels sound = table();
  sound.sampling_rate_hz = 8000;
  EXPECT_EQ(clock_of(sound, {}, "f.wav").rate_hz, 8000);
  EXPECT_EQ(clock_fault(table(), {}),
            "f.csv: says no times, allowed: with time or sampling_rate_hz in its description");
}

TEST(SampleClock, TimesThatDoNotRiseAreRefused) {
  Channels still = table();
  still.channels[0].values.assign(100, 0.0);
  EXPECT_EQ(clock_fault(still, {.time = "t"}),
            "f.csv: reading 2: 't' does not rise from 0 to 0, allowed: times one after the other");
}

/// The table with all times shifted from a row on.
Channels jumping(std::size_t row, double by) {
  Channels channels = table();
  for (std::size_t k = row; k < channels.rows(); ++k) channels.channels[0].values[k] += by;
  return channels;
}

TEST(SampleClock, OfATimeThatJumpsTheLongestStretchIsTaken) {
  std::vector<std::string> findings;
  const auto later = stretch_without_jump(jumping(30, 30.2), {.time = "t"}, "f.csv", findings);
  ASSERT_TRUE(later);
  EXPECT_EQ(later->rows(), 70u);
  EXPECT_EQ(later->channels[1].values.front(), 30);
  EXPECT_NEAR(clock_of(*later, {.time = "t"}, "f.csv").rate_hz, 2000, 1e-9);
  EXPECT_EQ(findings,
            (std::vector<std::string>{
                "'t' jumps from 19.5 to 50.2 at reading 31: the longest stretch without a jump, from "
                "50.2 to 84.7, is looked at"}));
  const Instrument early{.time = "t", .to_s = 0.019};
  EXPECT_EQ(stretch_without_jump(jumping(30, 30.2), early, "f.csv", findings)->rows(), 30u);
}

TEST(SampleClock, EvenTimesHaveOneStretchAndTimesThatStepBackAreRefused) {
  std::vector<std::string> findings;
  EXPECT_FALSE(stretch_without_jump(table(), {.time = "t"}, "f.csv", findings));
  EXPECT_FALSE(stretch_without_jump(jumping(30, -3), {.time = "t"}, "f.csv", findings));
  EXPECT_NE(clock_fault(jumping(30, -3), {.time = "t"}), "");
  Channels one_back = table();
  one_back.channels[0].values[40] = 5.5;
  EXPECT_FALSE(stretch_without_jump(one_back, {.time = "t"}, "f.csv", findings));
  Channels uneven = table();
  for (std::size_t k = 0; k < uneven.rows(); k += 7) uneven.channels[0].values[k] += 0.3;
  EXPECT_FALSE(stretch_without_jump(uneven, {.time = "t"}, "f.csv", findings));
  EXPECT_TRUE(findings.empty());
}

TEST(SampleClock, TwoColumnsOfOneNameAreRefused) {
  Channels twice = table();
  twice.channels[1].name = "t";
  EXPECT_EQ(clock_fault(twice, {.time = "t"}), "f.csv: has two columns 't', allowed: names that differ");
  EXPECT_EQ(find_channel(table(), "x", "f.csv").unit, "um");
}

TEST(SampleClock, AStretchOutsideOfTheRecordingIsRefused) {
  EXPECT_EQ(clock_fault(table(), {.time = "t", .from_s = 3}),
            "f.csv: lasts from 0.005 to 0.0545 s, allowed: from_s and to_s that leave some of it");
  EXPECT_EQ(clock_fault(table(), {.time = "t", .to_s = 0.001}),
            "f.csv: lasts from 0.005 to 0.0545 s, allowed: from_s and to_s that leave some of it");
  EXPECT_EQ(clock_fault(table(), {.time = "t", .from_s = 0.01, .to_s = 0.02}), "");
}

}  // namespace
}  // namespace rubsweep::recording
