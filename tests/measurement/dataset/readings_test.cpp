#include "rubsweep/measurement/dataset/readings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::dataset {
namespace {

using diagnose::samples_per_revolution;
using std::numbers::pi;

/// 20 turns at 50 Hz of an ellipse with a half order.
LabelledRecording ellipse() {
  LabelledRecording recording{.speed_hz = 50, .gain = {1, 1}};
  for (int k = 0; k < 20 * samples_per_revolution; ++k) {
    const double turn = static_cast<double>(k) / samples_per_revolution;
    recording.motion.displacement_m.push_back(2e-4 * std::polar(1.0, 2 * pi * turn) +
                                              1e-4 * std::polar(1.0, -pi * turn));
  }
  return recording;
}

Measurement plain() {
  Measurement measurement;
  measurement.noise_share = {0, 0};
  measurement.other_lines = {0, 0, 0};
  return measurement;
}

TEST(Readings, AreTheMotionAtTheirTimes) {
  LabelledRecording recording = ellipse();
  diagnose::RandomStream random(1, 0, 0);
  read_motion(plain(), random, recording);
  ASSERT_EQ(recording.t_s.size(), recording.x_m.size());
  ASSERT_EQ(recording.t_s.size(), recording.y_m.size());
  // 20 turns without their last sample.
  EXPECT_EQ(recording.t_s.size(), 2000u);
  for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
    const double turn = 50 * recording.t_s[k];
    const auto z = 2e-4 * std::polar(1.0, 2 * pi * turn) + 1e-4 * std::polar(1.0, -pi * turn);
    EXPECT_NEAR(recording.x_m[k], z.real(), 1e-10);
    EXPECT_NEAR(recording.y_m[k], z.imag(), 1e-10);
  }
}

TEST(Readings, MarkPassesOnceATurnWhereItStands) {
  // 5 is the fewest that a study may have.
  for (const double readings_per_turn : {5.0, 7.3, 18.5, 100.0}) {
    for (const double mark_turns : {0.0, 0.25, 0.66, 0.93}) {
      LabelledRecording recording = ellipse();
      diagnose::RandomStream random(1, 0, 0);
      Measurement measurement = plain();
      measurement.sampling_rate_hz = 50 * readings_per_turn;
      recording.mark_turns = mark_turns;
      read_motion(measurement, random, recording);
      int passages = recording.keyphasor_v.front() == mark_v;
      for (std::size_t k = 1; k < recording.t_s.size(); ++k) {
        if (!(recording.keyphasor_v[k] == mark_v && recording.keyphasor_v[k - 1] == no_mark_v)) continue;
        ++passages;
        const double late = 50 * recording.t_s[k] - mark_turns;
        EXPECT_LE(late - std::floor(late), (1 + 1e-9) / readings_per_turn) << mark_turns;
      }
      // Each mark until the last reading, and where it is passing at the begin the end of one passage.
      const int marks = static_cast<int>(std::floor(50 * recording.t_s.back() - mark_turns)) + 1;
      EXPECT_GE(marks, 19);
      EXPECT_EQ(passages, marks + (mark_turns + mark_share > 1)) << readings_per_turn << ' ' << mark_turns;
    }
  }
}

TEST(Readings, NoiseAndGainAreThoseThatAreSaid) {
  LabelledRecording recording = ellipse(), clean = ellipse();
  recording.gain = {1.1, 0.9};
  diagnose::RandomStream random(1, 0, 0), same(1, 0, 0);
  Measurement noisy = plain();
  noisy.noise_share = {0.05, 0.05};
  read_motion(noisy, random, recording);
  read_motion(plain(), same, clean);
  // The size of the motion: both circles together.
  EXPECT_NEAR(recording.noise_m, 0.05 * std::hypot(2e-4, 1e-4), 1e-9);
  double squares_x = 0, squares_y = 0;
  const auto count = static_cast<double>(clean.x_m.size());
  for (std::size_t k = 0; k < clean.x_m.size(); ++k) {
    squares_x += std::pow(recording.x_m[k] - 1.1 * clean.x_m[k], 2);
    squares_y += std::pow(recording.y_m[k] - 0.9 * clean.y_m[k], 2);
  }
  // Four standard errors of a standard deviation.
  for (const double squares : {squares_x, squares_y})
    EXPECT_NEAR(std::sqrt(squares / count) / recording.noise_m, 1, 4 / std::sqrt(2 * count));
}

TEST(Readings, OfOneProbeHaveNoY) {
  LabelledRecording recording = ellipse();
  recording.gain = {1};
  diagnose::RandomStream random(1, 0, 0);
  read_motion(plain(), random, recording);
  EXPECT_FALSE(recording.x_m.empty());
  EXPECT_TRUE(recording.y_m.empty());
}

}  // namespace
}  // namespace rubsweep::dataset
