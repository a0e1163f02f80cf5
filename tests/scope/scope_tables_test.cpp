#include "rubsweep/scope/scope_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace rubsweep::scope {
namespace {

recording::Recording circle(int turns) {
  recording::Recording recording{
      .sampling_rate_hz = 5000, .plane = true, .findings = {"'x' is clipped above"}};
  for (int turn = 0; turn <= turns; ++turn) recording.turn_begin_s.push_back(0.02 * turn);
  for (int k = 0; k < turns * recording::samples_per_revolution; ++k)
    recording.displacement_m.push_back(std::polar(
        5e-5, 2 * std::numbers::pi * k / recording::samples_per_revolution + std::numbers::pi / 4));
  return recording;
}

int rows(const std::string& table) { return static_cast<int>(std::ranges::count(table, '\n')) - 1; }

TEST(ScopeTables, HoldTheMotion) {
  const recording::Recording recording = circle(30);
  const ScopeTables tables =
      tables_of(recording, judge(recording.displacement_m, recording::samples_per_revolution, true));
  EXPECT_TRUE(tables.turns_csv.starts_with("turn,t_s,speed_hz,x_m,y_m\n0,0,50,"));
  EXPECT_EQ(rows(tables.turns_csv), 30);
  EXPECT_EQ(rows(tables.orbit_csv), recording::samples_per_revolution);
  EXPECT_EQ(rows(tables.lines_csv), 17);
  std::istringstream lines(tables.lines_csv);
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("1,")) {
  }
  double order = 0, amplitude_m = 0, uncertainty_m = 0, phase_deg = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &order, &amplitude_m, &uncertainty_m, &phase_deg),
            4);
  EXPECT_NEAR(amplitude_m, 5e-5, 1e-15);
  EXPECT_NEAR(phase_deg, 45, 1e-9);
  EXPECT_NE(tables.measures_csv.find("\nperiod_turns,1,\n"), std::string::npos);
  EXPECT_NE(tables.summary.find("synchronous, circle orbit, forward whirl\n"), std::string::npos);
  EXPECT_NE(tables.summary.find("100 um peak to peak in x, 100 um in y"), std::string::npos);
  EXPECT_TRUE(tables.summary.ends_with("warning   'x' is clipped above\n"));
}

TEST(ScopeTables, SayHowLongARecordingMustBe) {
  const recording::Recording recording = circle(12);
  const ScopeTables tables =
      tables_of(recording, judge(recording.displacement_m, recording::samples_per_revolution, true));
  // 24 turns tell periods of up to 8; twelve more take 0.24 s.
  EXPECT_NE(tables.summary.find(
                "periods of more than 4 turns cannot be told by 12 turns; 0.24 s more would tell up to 8"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::scope
