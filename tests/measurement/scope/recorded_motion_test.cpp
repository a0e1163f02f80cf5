#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

/// Tests verdicts on recordings made from the columns of a table.
namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A 1/2 subharmonic at about 70 Hz, read at 5 kHz, with a keyway whose edges last `edge` samples.
recording::Channels half_order(double speed_hz, double edge, double noise_um) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, noise_um);
  recording::Channels table;
  table.channels = {{"X", "um", {}}, {"Y", "um", {}}, {"KP", "V", {}}};
  for (int k = 0; k < 10000; ++k) {
    const double turns = speed_hz * k / 5000 + 0.4;
    const Complex z = 80.0 * std::polar(1.0, 2 * pi * turns) + Complex(50, 20) * std::polar(1.0, pi * turns) +
                      30.0 * std::polar(1.0, -pi * turns);
    const double since = (turns - std::floor(turns)) / speed_hz * 5000;
    table.channels[0].values.push_back(z.real() + noise(random));
    table.channels[1].values.push_back(z.imag() + noise(random));
    table.channels[2].values.push_back(since < 6 ? -2 - 10 * std::fmin(1, since / edge) : -2);
  }
  return table;
}

const recording::Instrument instrument{.sampling_rate_hz = 5000,
                                       .probes = {{"X", 0}, {"Y", 90}},
                                       .keyphasor = recording::Keyphasor{.column = "KP"}};

TEST(RecordedMotion, EdgesBetweenTwoSamplesDoNotSmearItsLines) {
  // Speeds whose turns are whole, nearly whole and arbitrary numbers of samples.
  for (const double speed_hz : {5000.0 / 71, 5000.0 / 71.02, 5000.0 / 71.37, 70.0}) {
    for (const double edge : {0.01, 1.4, 3.0}) {
      const auto read = recording::make_recording(half_order(speed_hz, edge, 0.5), instrument, "f");
      const Verdict verdict = judge(read);
      EXPECT_EQ(verdict.motion, MeasuredClass::subharmonic) << speed_hz << ' ' << edge;
      EXPECT_EQ(verdict.period, 2) << speed_hz << ' ' << edge;
    }
  }
}

/// A motion with lines at multiples of 1 / period, read `readings` times per turn, with a sharp-edged mark.
struct Read {
  double readings = 0;      ///< readings per turn at the start
  double speed_change = 0;  ///< relative change from start to end
  int period = 1;
  double mark_share = 0.25, noise = 1e-3;  ///< share of a turn covered by the mark; noise / 1X
};

recording::Recording recorded(const Read& read, unsigned seed, int turns = 32) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  struct Line {
    double order;
    Complex amplitude;
  };
  std::vector<Line> lines;
  const auto add = [&](double order, double size) {
    // An anti-aliasing filter removes higher orders.
    if (std::abs(order) < 0.45 * read.readings)
      lines.push_back({order, std::polar(size, 2 * pi * uniform(random))});
  };
  add(1, 100);
  add(-1, 20 * uniform(random));
  for (const double order : {2.0, -2.0}) add(order, 10 * uniform(random));
  for (const double order : {3.0, -3.0}) add(order, 3 * uniform(random));
  if (read.period > 1) add(1.0 / read.period, 30);
  const double first_turns = uniform(random);
  recording::Channels table;
  table.channels = {{"X", "um", {}}, {"Y", "um", {}}, {"KP", "V", {}}};
  for (int k = 0;; ++k) {
    const double steady = k / read.readings,
                 whirled = steady + read.speed_change * steady * steady / (2 * turns);
    if (whirled > turns) break;
    const double angle = first_turns + whirled;
    Complex z;
    for (const Line& line : lines) z += line.amplitude * std::polar(1.0, 2 * pi * line.order * angle);
    table.channels[0].values.push_back(z.real() + 100 * read.noise * normal(random));
    table.channels[1].values.push_back(z.imag() + 100 * read.noise * normal(random));
    table.channels[2].values.push_back(angle - std::floor(angle) < read.mark_share ? -12 : -2);
  }
  return recording::make_recording(table, instrument, "f");
}

constexpr double readings_of_a_turn[]{5.37, 6, 8.2, 12.9, 21.3, 33.3334, 50.02, 71, 111.8, 200.4};

TEST(RecordedMotion, MarksThatAreKnownToAReadingRaiseNoFalseAlarms) {
  int count = 0, alarms = 0;
  for (const double readings : readings_of_a_turn) {
    for (const double change : {0.0, 3e-3}) {
      for (int k = 0; k < 15; ++k) {
        const double noise = 1e-3 * std::pow(30, k / 14.0);
        const auto seed = static_cast<unsigned>(count);
        const auto read = recorded({.readings = readings, .speed_change = change, .noise = noise}, seed);
        ++count;
        alarms += judge(read).motion != MeasuredClass::synchronous;
      }
    }
  }
  // Three false alarms are expected at 1 %; more than seven occur in 1 % of such sets.
  EXPECT_EQ(count, 300);
  EXPECT_LE(alarms, 7);
  RecordProperty("false_alarms", alarms);
}

TEST(RecordedMotion, MarksThatAreKnownToAReadingLeaveThePeriod) {
  int count = 0, right = 0;
  for (const double readings : readings_of_a_turn) {
    for (const double change : {0.0, 3e-3}) {
      for (const int period : {2, 3, 5}) {
        for (int k = 0; k < 4; ++k) {
          const auto seed = static_cast<unsigned>(count);
          const auto read =
              recorded({.readings = readings, .speed_change = change, .period = period, .noise = 1e-2}, seed);
          ++count;
          right += judge(read).period == period;
        }
      }
    }
  }
  EXPECT_EQ(count, 240);
  EXPECT_GE(right, count - 6);
  RecordProperty("right", right);
}

}  // namespace
}  // namespace rubsweep::scope
