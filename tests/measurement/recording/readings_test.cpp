#include "rubsweep/measurement/recording/readings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

/// Two columns of 1000 readings over 40 turns, a quarter of a turn apart.
Channels two_columns(const char* unit) {
  Channels channels;
  channels.channels = {{"A", unit, {}}, {"B", unit, {}}};
  for (int k = 0; k < 1000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 25;
    channels.channels[0].values.push_back(3 * std::cos(angle) + 0.01 * std::cos(7.3 * angle));
    channels.channels[1].values.push_back(2 * std::sin(angle) + 0.01 * std::sin(5.7 * angle));
  }
  return channels;
}

const Instrument along_x_and_y{.probes = {{.column = "A"}, {.column = "B", .angle_deg = 90}}};

std::string readings_fault(const Channels& channels, const Instrument& instrument) {
  std::vector<std::string> findings;
  try {
    readings_of(channels, instrument, "f.csv", findings);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Readings, AreInSiUnitsOfTheirQuantity) {
  const struct {
    const char* unit;
    double si;
    int integrations;
    Place place;
  } rows[] = {
      {"um", 1e-6, 0, Place::shaft}, {"mm/s", 1e-3, 1, Place::casing}, {"m/s^2", 1, 2, Place::casing}};
  for (const auto& row : rows) {
    std::vector<std::string> findings;
    const Readings readings = readings_of(two_columns(row.unit), along_x_and_y, "f.csv", findings);
    EXPECT_EQ(readings.integrations(), row.integrations) << row.unit;
    EXPECT_EQ(readings.place, row.place) << row.unit;
    ASSERT_EQ(readings.probes.size(), 2u);
    EXPECT_EQ(readings.probes[1].angle_deg, 90);
    EXPECT_NEAR(readings.probes[0].values[0], 3.01 * row.si, 1e-12) << row.unit;
    EXPECT_TRUE(findings.empty()) << findings[0];
  }
}

TEST(Readings, OfAStretchAreThoseFromItsBeginningUpToItsEnd) {
  Readings readings{.probes = {{.column = "A", .values = {0, 1, 2, 3, 4, 5, 6, 7}}}};
  const SampleClock clock{.first_s = 10, .rate_hz = 2};
  EXPECT_EQ(readings.stretch(clock)[0].size(), 8u);
  EXPECT_EQ(readings.stretch(clock, 11, 12.6)[0], (std::vector<double>{2, 3, 4, 5}));
  EXPECT_EQ(readings.stretch(clock, {}, 10.5)[0], std::vector<double>{0});
  EXPECT_EQ(readings.stretch(clock, 12.9)[0], (std::vector<double>{6, 7}));
  EXPECT_TRUE(readings.stretch(clock, 99)[0].empty());
}

TEST(Readings, AreOfOneQuantityAndOnePart) {
  Channels mixed = two_columns("um");
  mixed.channels[1].unit = "mm/s";
  EXPECT_EQ(readings_fault(mixed, along_x_and_y),
            "f.csv: 'B': measures another quantity than the first probe, allowed: probes of one quantity");
  Instrument instrument = along_x_and_y;
  instrument.probes[1].on = Place::casing;
  EXPECT_EQ(readings_fault(two_columns("um"), instrument),
            "f.csv: the probes are on different parts (on), allowed: one part");
  instrument = along_x_and_y;
  instrument.probes[0].rest = 1;
  EXPECT_EQ(readings_fault(two_columns("um"), instrument), "none");
  EXPECT_EQ(readings_fault(two_columns("mm/s"), instrument),
            "f.csv: 'A': measures no displacement and has a reading at rest, allowed: no rest");
  instrument = along_x_and_y;
  instrument.run_out = RunOut{0, 1};
  EXPECT_EQ(readings_fault(two_columns("g"), instrument),
            "f.csv: 'A': measures no displacement and has a run-out, allowed: no run_out");
}

TEST(Readings, OfAStuckProbeAreLeftOutIfEnoughTurnsRemain) {
  const struct {
    std::size_t first, count;
    int turns;
    bool left_out;
  } rows[] = {{50, 300, 39, true}, {130, 120, 11, false}};
  for (const auto& row : rows) {
    Channels channels = two_columns("um");
    std::vector<double>& values = channels.channels[0].values;
    std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(row.first), row.count, values[row.first]);
    std::vector<std::string> findings, compared;
    Readings readings = readings_of(channels, along_x_and_y, "f.csv", findings);
    std::vector<double> turn_begin_s;
    for (int turn = 0; turn <= row.turns; ++turn) turn_begin_s.push_back(0.025 * turn);
    look_for_faults(readings, {.first_s = 0, .rate_hz = 1000}, turn_begin_s, compared);
    ASSERT_EQ(compared.size(), 1u) << row.first;
    EXPECT_TRUE(compared[0].starts_with("'A' stands still from ")) << compared[0];
    EXPECT_EQ(compared[0].ends_with(": these readings are left out"), row.left_out) << compared[0];
    EXPECT_EQ(std::isnan(readings.probes[0].values[row.first + 1]), row.left_out);
    EXPECT_FALSE(std::isnan(readings.probes[1].values[row.first + 1]));
  }
}

}  // namespace
}  // namespace rubsweep::recording
