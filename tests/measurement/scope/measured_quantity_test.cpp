#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"
#include "rubsweep/measurement/scope/waterfall.hpp"

/// Recordings of one motion as displacement, velocity and acceleration, differentiated in closed form.
namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

struct ShaftLine {
  double order = 0;
  Complex amplitude_um;
};

struct MadeMotion {
  double speed_hz = 40, rate_hz_per_s = 0;  ///< speed at the begin, and its rise
  std::vector<ShaftLine> lines{};
  double noise = 0;  ///< standard deviation of a reading, in the unit of the file
  int turns = 40;
  unsigned seed = 1;
};

struct WrittenAs {
  const char* unit = "um";
  int times = 0;
  double of_um = 1;  ///< unit by um, um/s or um/s^2
  std::optional<double> gain_mv_per_g{}, gain_mv_per_mm_per_s{};
};

const std::vector<WrittenAs> forms{{"um", 0, 1},
                                   {"mm/s", 1, 1e-3},
                                   {"in/s", 1, 1 / 25400.0},
                                   {"m/s\u00b2", 2, 1e-6},
                                   {"g", 2, 1 / 9.80665e6},
                                   {"V", 2, 0.1 / 9.80665e6, 100.0, {}},
                                   {"mV", 1, 4e-3, {}, 4.0}};

recording::Recording recorded(const MadeMotion& made, const WrittenAs& as) {
  std::mt19937_64 random(made.seed);
  std::normal_distribution<double> noise(0, made.noise);
  recording::Channels table;
  table.channels = {{"X", as.unit, {}}, {"Y", as.unit, {}}, {"KP", "V", {}}};
  constexpr double rate_hz = 5000;
  for (int k = 0;; ++k) {
    const double t = k / rate_hz, turns = (made.speed_hz + made.rate_hz_per_s * t / 2) * t;
    if (turns > made.turns) break;
    const double omega = 2 * pi * (made.speed_hz + made.rate_hz_per_s * t),
                 alpha = 2 * pi * made.rate_hz_per_s;
    Complex z;
    for (const auto& [order, amplitude] : made.lines) {
      const Complex turning(0, order * omega);
      const Complex factor = as.times == 0   ? Complex(1)
                             : as.times == 1 ? turning
                                             : turning * turning + Complex(0, order * alpha);
      z += amplitude * factor * std::polar(1.0, 2 * pi * order * turns);
    }
    // Instruments have an offset.
    const double offset = 30 * std::pow(2 * pi * made.speed_hz, as.times);
    table.channels[0].values.push_back(as.of_um * (z.real() + offset) + noise(random));
    table.channels[1].values.push_back(as.of_um * (z.imag() - offset) + noise(random));
    const double since = turns - std::floor(turns);
    table.channels[2].values.push_back(since < 0.1 ? -10 + 8 * std::max(0.0, 1 - since * 60) : -2);
  }
  recording::Probe probe{.column = "X"};
  probe.gain_mv_per_g = as.gain_mv_per_g;
  probe.gain_mv_per_mm_per_s = as.gain_mv_per_mm_per_s;
  recording::Probe other = probe;
  other.column = "Y";
  other.angle_deg = 90;
  const recording::Instrument instrument{.sampling_rate_hz = rate_hz,
                                         .probes = {probe, other},
                                         .keyphasor = recording::Keyphasor{.column = "KP"}};
  return recording::make_recording(table, instrument, "made.csv");
}

const std::vector<ShaftLine> half_lines{
    {1, {50, 0}}, {-1, {5, 8}}, {0.5, {0, 12}}, {-1.5, {3, 0}}, {3, {1, 1}}};

TEST(MeasuredQuantity, VelocityAndAccelerationHaveTheOrdersOfTheDisplacement) {
  const Verdict displacement = judge(recorded({.lines = half_lines}, forms[0]));
  ASSERT_EQ(displacement.period, 2);
  for (const WrittenAs& as : forms) {
    const recording::Recording read = recorded({.lines = half_lines}, as);
    EXPECT_EQ(read.integration.times, as.times);
    EXPECT_EQ(read.place, as.times == 0 ? recording::Place::shaft : recording::Place::casing);
    const Verdict verdict = judge(read);
    ASSERT_EQ(verdict.period, 2) << as.unit;
    for (std::size_t k = 0; k < verdict.lines.size(); ++k) {
      if (verdict.lines[k].order == 0) continue;
      EXPECT_LT(std::abs(verdict.lines[k].amplitude_m - displacement.lines[k].amplitude_m), 3e-9)
          << as.unit << ' ' << verdict.lines[k].order;
    }
  }
}

TEST(MeasuredQuantity, OfARunUpMovesNoOrder) {
  const MadeMotion made{.speed_hz = 20, .rate_hz_per_s = 10, .lines = half_lines, .turns = 120};
  const auto displacement = order_history(recorded(made, forms[0]), 1);
  for (const WrittenAs& as : forms) {
    const auto history = order_history(recorded(made, as), 1);
    ASSERT_EQ(history.size(), displacement.size());
    // Orders below the lowest one are missed most near the ends.
    for (std::size_t k = 16; k + 16 < history.size(); ++k)
      ASSERT_LT(std::abs(history[k].x_m - displacement[k].x_m), as.times == 1 ? 0.1e-6 : 1e-6)
          << as.unit << ' ' << k;
  }
}

TEST(MeasuredQuantity, NoiseThatFallsWithTheOrderRaisesNoFalseAlarms) {
  const std::vector<ShaftLine> ellipse{{1, {50, 0}}, {-1, {5, 8}}, {2, {1, 1}}};
  int alarms = 0, found = 0, count = 0;
  for (const WrittenAs& as : {forms[1], forms[3]}) {
    // At order 1 the noise of a line is about 0.05 um.
    const double noise = as.of_um * std::pow(2 * pi * 40, as.times) * 3;
    for (unsigned seed = 1; seed <= 10; ++seed, ++count) {
      alarms += judge(recorded({.lines = ellipse, .noise = noise, .seed = seed}, as)).motion !=
                MeasuredClass::synchronous;
      found += judge(recorded({.lines = half_lines, .noise = noise, .seed = seed}, as)).period == 2;
    }
  }
  // One false alarm in a hundred is expected; more than one occurs in 2 % of such sets.
  EXPECT_LE(alarms, 1);
  EXPECT_GE(found, count - 1);
}

TEST(MeasuredQuantity, ProbesOfTwoKindsAreRefused) {
  recording::Channels table;
  table.channels = {{"X", "um", {}}, {"A", "g", {}}};
  for (int k = 0; k < 4000; ++k)
    for (recording::Channel& channel : table.channels) channel.values.push_back(std::sin(0.05 * k));
  const auto fault = [&](std::vector<recording::Probe> probes) {
    try {
      recording::make_recording(
          table, {.sampling_rate_hz = 5000, .probes = std::move(probes), .speed_hz = 40}, "f.csv");
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(fault({{"X", 0}, {"A", 90}}),
            "f.csv: 'A': measures another quantity than the first probe, allowed: probes of one quantity");
  recording::Probe rest{.column = "A", .rest = 0.1}, there{.column = "A", .angle_deg = 90};
  EXPECT_EQ(fault({rest}),
            "f.csv: 'A': measures no displacement and has a reading at rest, allowed: no rest");
  there.on = recording::Place::shaft_absolute;
  EXPECT_EQ(fault({{"A", 0}, there}), "f.csv: the probes are on different parts (on), allowed: one part");
  EXPECT_EQ(fault({there}), "none");
}

}  // namespace
}  // namespace rubsweep::scope
