#include "rubsweep/measurement/diagnosis/compared_stretches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnosis {
namespace {

/// A circular motion of 20 um at 1X and a forward line at 1/2X whose amplitude in metres depends on the turn.
/// The speed rises by `rate` from turn to turn.
recording::Recording run_up(
    int turns, double rate, const std::function<double(double)>& half_order_m,
    const std::function<double(double)>& first_order_m = [](double) { return 2e-5; }) {
  recording::Recording recording{.sampling_rate_hz = 6000, .turn_begin_s = {0}, .plane = true};
  for (int turn = 0; turn < turns; ++turn)
    recording.turn_begin_s.push_back(recording.turn_begin_s.back() + 1 / (40 * std::exp(rate * turn)));
  for (int k = 0; k < turns * recording::samples_per_revolution; ++k) {
    const double turn = static_cast<double>(k) / recording::samples_per_revolution,
                 angle = 2 * std::numbers::pi * turn;
    recording.displacement_m.push_back(std::polar(first_order_m(turn), angle) +
                                       std::polar(half_order_m(turn), angle / 2));
  }
  return recording;
}

double none(double) { return 0; }

TEST(ComparedStretches, OfASteadyRecordingAreItsLastTurns) {
  const auto stretches = compared_stretches(run_up(100, 0, none), "run.csv");
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_EQ(stretches[0].first_turn, 100 - most_turns);
  EXPECT_EQ(stretches[0].turns, most_turns);
  EXPECT_NEAR(stretches[0].speed_hz, 40, 1e-9);
  EXPECT_EQ(compared_stretches(run_up(20, 0, none), "run.csv")[0].turns, 20);
}

TEST(ComparedStretches, OfARunUpShowTheRubAndOtherSpeeds) {
  const auto rubs = [](double turn) { return turn > 200 && turn < 260 ? 1e-5 : 0; };
  const auto stretches = compared_stretches(run_up(400, 5e-4, rubs), "run.csv");
  ASSERT_EQ(stretches.size(), 3U);
  EXPECT_GE(stretches[0].first_turn, 185);
  EXPECT_LE(stretches[0].first_turn + stretches[0].turns, 275);
  // The farthest in speed from turn 230 is the beginning, and then the end.
  EXPECT_LT(stretches[1].first_turn, 30);
  EXPECT_GT(stretches[2].first_turn, 345);
  for (const Stretch& stretch : stretches) {
    EXPECT_EQ(stretch.turns, most_turns);
    const double middle = stretch.first_turn + stretch.turns / 2.0;
    EXPECT_NEAR(stretch.speed_hz / (40 * std::exp(5e-4 * middle)), 1, 1e-3);
  }
}

TEST(ComparedStretches, AreShorterWhereTheSpeedChangesFaster) {
  // In n turns an order near 1 moves by rate * n of itself, and that is rate * n * n lines.
  const double rate = 1.6e-3;
  const auto stretches = compared_stretches(run_up(300, rate, none), "run.csv");
  EXPECT_EQ(stretches.front().turns, static_cast<int>(std::sqrt(0.6 / rate)));
}

TEST(ComparedStretches, LeaveOutTheGrowingMotionOfAResonance) {
  // Between turns 180 and 220 the motion grows by 5 % a turn and decays again; beside 1X it has nothing.
  const auto resonance = [](double turn) {
    return 2e-5 * std::exp(0.05 * std::fmax(0, 20 - std::fabs(turn - 200)));
  };
  for (const Stretch& stretch : compared_stretches(run_up(400, 5e-4, none, resonance), "run.csv"))
    EXPECT_TRUE(stretch.first_turn + stretch.turns < 200 || stretch.first_turn > 200);
}

TEST(ComparedStretches, OfARunUpHaveLinesAt1XThatDoNotGrow) {
  const auto growing = [](double turn) { return 2e-5 * (1 + turn / 100); };
  const auto half = [](double) { return 1e-6; };
  const Stretch stretch{100, 30, 42, true};
  const diagnose::MotionLines alone = lines_of(run_up(400, 5e-4, none, growing), stretch),
                              beside = lines_of(run_up(400, 5e-4, half, growing), stretch),
                              steady = lines_of(run_up(400, 0, none, growing), {100, 30, 40});
  // The amplitude at 1X is that of the middle of the stretch, at turn 115.
  for (int k = -60; k <= 60; ++k) EXPECT_NEAR(std::abs(alone.at(k)), k == 30 ? 4.3e-5 : 0, 2e-9) << k;
  EXPECT_NEAR(std::abs(beside.at(15)), 1e-6, 1e-8);
  // A steady machine has no such growth; what grows there is seen.
  EXPECT_GT(std::abs(steady.at(31)), 5e-7);
}

TEST(ComparedStretches, OfASpeedThatChangesFastOrOfAFewTurnsAreRefused) {
  const auto refused = [](const recording::Recording& recording) {
    try {
      compared_stretches(recording, "run.csv");
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused(run_up(11, 0, none)), "run.csv: has 11 whole turns, allowed: 12 or more");
  EXPECT_EQ(refused(run_up(60, 6e-3, none)),
            "run.csv: the speed changes by 5 % or more in 12 turns, allowed: a slower run-up, or from_s "
            "and to_s");
  EXPECT_EQ(refused(run_up(60, 3e-3, none)), "");
}

TEST(ComparedStretches, HaveTheLinesOfTheirTurns) {
  const auto steps = [](double turn) { return turn < 60 ? 1e-6 : 3e-6; };
  const recording::Recording recording = run_up(120, 0, steps);
  for (const int first : {0, 80}) {
    const diagnose::MotionLines lines = lines_of(recording, {first, 20, 40});
    EXPECT_NEAR(std::abs(lines.at(10)), first == 0 ? 1e-6 : 3e-6, 1e-9);
    EXPECT_NEAR(std::abs(lines.at(20)), 2e-5, 1e-9);
  }
  // 30 readings a turn show orders up to 8, 12.5 up to 5.
  EXPECT_EQ(lines_of(recording, {0, 20, 200}).last(), 8 * 20);
  EXPECT_EQ(lines_of(recording, {0, 20, 480}).last(), 5 * 20);
}

}  // namespace
}  // namespace rubsweep::diagnosis
