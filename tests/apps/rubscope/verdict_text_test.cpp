#include "rubscope/verdict_text.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {
namespace {

using namespace scope;

Verdict every_second_turn() {
  return {.motion = MeasuredClass::subharmonic,
          .turns = 40,
          .period = 2,
          .longest_period = 8,
          .noise_m = 1e-8,
          .visible_m = 4e-7,
          .modulation_m = 1e-6,
          .seen_m = 1e-7,
          .lines = {{.order = 0, .amplitude_m = 1}, {.order = 0.5, .amplitude_m = 3e-5}, {1, 4e-5}}};
}

TEST(VerdictText, NamesMotionShapeAndWhirl) {
  Verdict verdict = every_second_turn();
  EXPECT_EQ(motion_text(verdict), "subharmonic 1/2");
  verdict.shape = response::spectrum::OrbitKind::oval;
  verdict.whirl = response::spectrum::WhirlKind::forward;
  EXPECT_EQ(motion_text(verdict), "subharmonic 1/2, oval orbit, forward whirl");
  verdict.period.reset();
  verdict.motion = MeasuredClass::quasi_periodic;
  EXPECT_EQ(motion_text(verdict), "quasi_periodic: repeats after no number of turns up to 8");
}

TEST(VerdictText, SaysWhatALongerRecordingWouldTell) {
  Verdict verdict = every_second_turn();
  EXPECT_EQ(doubt_text(verdict, 50, {}), "no line of 0.4 um or more belongs to another period\n");
  verdict.longest_period = 4;
  verdict.turns = 12;
  EXPECT_EQ(doubt_text(verdict, 50, {}),
            "periods of more than 4 turns cannot be told by 12 turns; 0.24 s more would tell up to 8\n");
  verdict.doubtful = DoubtfulPeriod{.turns = 4, .amplitude_m = 3e-7, .more_turns = 10};
  EXPECT_EQ(doubt_text(verdict, 50, {}),
            "1/2 or 1/4: 0.2 s more would tell (a line of 0.3 um, seen from 0.4 um on)\n");
}

TEST(VerdictText, SaysHowMuchLinesVaryAndWhatStandsBesideThePeriod) {
  Verdict verdict = every_second_turn();
  EXPECT_EQ(content_text(verdict, {}), "unsteady  lines vary slowly by 2 % of the motion, 10 % may be\n");
  verdict.beside_m = 1.2e-7;
  EXPECT_EQ(
      content_text(verdict, {}),
      "unsteady  lines vary slowly by 2 % of the motion, 10 % may be; beside the period stands a line of "
      "0.12 um, 0.3 % of the largest one, too small to count below 0.5 %\n");
  verdict.motion = MeasuredClass::at_rest;
  EXPECT_EQ(content_text(verdict, {}), "");
}

}  // namespace
}  // namespace rubsweep::apps
