#include "rubscope/scope_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

namespace rubsweep::apps {

using namespace scope;

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
      tables_of(recording, judge(recording.displacement_m, recording::samples_per_revolution, true), {1, 2});
  EXPECT_TRUE(tables.turns_csv.starts_with("turn,t_s,speed_hz,x_m,y_m,centre_x_m,centre_y_m\n0,0,50,"));
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
  EXPECT_TRUE(
      tables.summary.starts_with("speed     50 Hz (3000 rpm), 50 to 50 Hz (3000 to 3000 rpm), 30 turns, "));
  EXPECT_TRUE(tables.summary.ends_with("warning   'x' is clipped above\n"));
}

/// Two lines of a period of seven turns, of which the measured one is 0.015 bins away from its multiple.
TEST(ScopeTables, ALineBesideItsMultipleIsWithinItsUncertainties) {
  constexpr int turns = 140;
  const double order = 4.0 / 7 + 0.015 / turns, size_m = 2e-5;
  recording::Recording recording = circle(turns);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 2e-8);
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double turn = static_cast<double>(k) / recording::samples_per_revolution;
    recording.displacement_m[k] +=
        std::polar(size_m, 2 * std::numbers::pi * order * turn) + std::complex(noise(random), noise(random));
  }
  const Verdict verdict = judge(recording.displacement_m, recording::samples_per_revolution, true);
  ASSERT_EQ(verdict.period, 7);
  std::istringstream lines(tables_of(recording, verdict, {1, 2}).lines_csv);
  bool found = false;
  for (std::string line; std::getline(lines, line);) {
    double of_bin = 0, found_order = 0, doubt = 0, amplitude_m = 0, uncertainty_m = 0, ignored = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &of_bin, &ignored, &ignored,
                    &ignored, &ignored, &found_order, &doubt, &amplitude_m, &uncertainty_m) != 9)
      continue;
    if (of_bin == 1) {
      EXPECT_EQ(doubt, 0);
    }
    if (std::abs(of_bin - order) > 0.05) continue;
    found = true;
    EXPECT_LE(std::abs(found_order - order), 2 * doubt);
    EXPECT_LT(doubt, 0.02 / turns);
    EXPECT_LE(std::abs(amplitude_m - size_m), 2 * uncertainty_m);
    EXPECT_LT(uncertainty_m, 1e-3 * size_m);
  }
  EXPECT_TRUE(found);
}

TEST(ScopeTables, SayLengthsAsTheyAreAskedFor) {
  const recording::Recording recording = circle(30);
  const Verdict verdict = judge(recording.displacement_m, recording::samples_per_revolution, true);
  const ScopeTables tables = tables_of(recording, verdict, {1, 2}, {model::LengthUnit::mil, true});
  EXPECT_NE(tables.summary.find("3.937 mil peak to peak in x, 3.937 mil in y"), std::string::npos)
      << tables.summary;
  EXPECT_EQ(tables.measures_csv, tables_of(recording, verdict, {1, 2}).measures_csv);
}

TEST(ScopeTables, SayHowMuchLinesVaryAndMay) {
  recording::Recording growing = circle(40);
  const std::size_t count = growing.displacement_m.size();
  for (std::size_t k = 0; k < count; ++k)
    growing.displacement_m[k] *= 1 + 0.1 * (static_cast<double>(k) / static_cast<double>(count) - 0.5);
  // Linear growth by 10 % has a root mean square of 2.9 %.
  const auto said = [&](double most_modulation) {
    const Verdict verdict = judge(growing.displacement_m, recording::samples_per_revolution, true,
                                  {.thresholds = {.most_modulation = most_modulation}});
    return tables_of(growing, verdict, {1}).summary;
  };
  for (const char* words : {"synchronous", "lines vary slowly by 2.9 % of the motion, 10 % may be"})
    EXPECT_NE(said(0.1).find(words), std::string::npos) << said(0.1);
  for (const char* words : {"periodic", "vary slowly by 2.9 % of the motion; up to 1 %"})
    EXPECT_NE(said(0.01).find(words), std::string::npos) << said(0.01);
}

TEST(ScopeTables, SayHowLongARecordingMustBe) {
  const recording::Recording recording = circle(12);
  const ScopeTables tables =
      tables_of(recording, judge(recording.displacement_m, recording::samples_per_revolution, true), {1, 2});
  // 24 turns can show periods of up to 8; the missing twelve turns take 0.24 s.
  EXPECT_NE(tables.summary.find(
                "periods of more than 4 turns cannot be told by 12 turns; 0.24 s more would tell up to 8"),
            std::string::npos);
}

/// A mode of 30 Hz with damping ratio 0.03, passed at 2 Hz/s, computed by small steps of the classical
/// Runge-Kutta method.
TEST(ScopeTables, FindTheModeOfARunUp) {
  const double w = 2 * std::numbers::pi * 30, zeta = 0.03, from = 22, rate = 2, step = 2e-5;
  const auto phi = [&](double t) { return 2 * std::numbers::pi * (from * t + rate * t * t / 2); };
  const auto pull = [&](double t, double x, double v) {
    const double speed = 2 * std::numbers::pi * (from + rate * t);
    return 1e-5 * (speed * speed * std::cos(phi(t)) + 2 * std::numbers::pi * rate * std::sin(phi(t))) -
           w * w * x - 2 * zeta * w * v;
  };
  recording::Recording recording{.sampling_rate_hz = 5000};
  double x = 0, v = 0;
  long sample = 0;
  for (long n = 0; static_cast<double>(n) * step < 8; ++n) {
    const double t = static_cast<double>(n) * step;
    if (phi(t) >= 2 * std::numbers::pi * static_cast<double>(sample) / recording::samples_per_revolution) {
      if (sample % recording::samples_per_revolution == 0) recording.turn_begin_s.push_back(t);
      recording.displacement_m.emplace_back(x, 0);
      ++sample;
    }
    const double a1 = pull(t, x, v), v2 = v + step / 2 * a1, a2 = pull(t + step / 2, x + step / 2 * v, v2),
                 v3 = v + step / 2 * a2, a3 = pull(t + step / 2, x + step / 2 * v2, v3), v4 = v + step * a3,
                 a4 = pull(t + step, x + step * v3, v4);
    x += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  const std::size_t turns = recording.turn_begin_s.size() - 1;
  recording.displacement_m.resize(turns * recording::samples_per_revolution);
  const ScopeTables tables = tables_of_run(recording, {1});
  double resonance_hz = 0, ratio = 0;
  const std::size_t at = tables.measures_csv.find("resonance_x_hz,");
  ASSERT_NE(at, std::string::npos) << tables.summary;
  ASSERT_EQ(std::sscanf(tables.measures_csv.c_str() + at, "resonance_x_hz,%lf,\ndamping_ratio_x,%lf",
                        &resonance_hz, &ratio),
            2);
  EXPECT_NEAR(resonance_hz, 30, 0.03);
  EXPECT_NEAR(ratio, 0.03, 0.001);
  EXPECT_TRUE(tables.orbit_csv.empty());
}

}  // namespace
}  // namespace rubsweep::apps
