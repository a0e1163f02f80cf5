#include "measurement/scope/unsteady_recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "rubsweep/measurement/scope/verdict.hpp"

/// Verdicts on machines that are not quite steady, both ways. RUBSWEEP_LONG asks for 200 recordings of each
/// kind.
namespace rubsweep::scope {
namespace {

unsigned recordings() { return std::getenv("RUBSWEEP_LONG") ? 200 : 8; }

Unsteady drawn(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  return {.speed_wander = 3e-3 * uniform(random),
          .amplitude_wander = 0.05 * uniform(random),
          .noise_share = 1e-3 * std::pow(20, uniform(random)),
          .readings_per_turn = 12 + 60 * uniform(random),
          .turns = static_cast<int>(24 + 70 * uniform(random))};
}

TEST(UnsteadyRecording, ACircleThatWandersIsSynchronous) {
  unsigned wrong = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed)
    wrong += judge(recorded(drawn(seed), seed)).motion != MeasuredClass::synchronous;
  RecordProperty("wrong", static_cast<int>(wrong));
  EXPECT_LE(wrong, recordings() / 40);
}

TEST(UnsteadyRecording, AHalfOrderOfAPerCentIsFound) {
  unsigned wrong = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(1000 + seed);
    put.other_order = seed % 2 == 0 ? 0.5 : -0.5;
    put.other_share = 0.01;
    put.speed_wander = put.amplitude_wander = 0;
    put.noise_share = 3e-3;
    wrong += judge(recorded(put, seed)).period != 2;
  }
  RecordProperty("wrong", static_cast<int>(wrong));
  EXPECT_EQ(wrong, 0u);
}

TEST(UnsteadyRecording, AStrongHalfOrderThatSwingsIsOftenFoundAndNeverSynchronous) {
  unsigned synchronous = 0, half = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(4000 + seed);
    put.other_order = 0.5;
    put.other_share = 0.3;
    put.other_swing = 0.2;
    const Verdict verdict = judge(recorded(put, seed));
    synchronous += verdict.motion == MeasuredClass::synchronous;
    half += verdict.period == 2;
  }
  RecordProperty("half", static_cast<int>(half));
  EXPECT_EQ(synchronous, 0u);
  EXPECT_GE(half, recordings() / 2);
}

TEST(UnsteadyRecording, ALineThatNoPeriodHasIsFoundOnAMachineThatWanders) {
  unsigned synchronous = 0, periodic = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(2000 + seed);
    std::mt19937_64 random(seed);
    put.other_order = std::uniform_real_distribution<double>(0.13, 0.87)(random);
    put.other_share = 0.01 + 0.02 * (seed % 2);
    const Verdict verdict = judge(recorded(put, seed));
    synchronous += verdict.motion == MeasuredClass::synchronous;
    periodic += verdict.motion == MeasuredClass::subharmonic;
  }
  RecordProperty("synchronous", static_cast<int>(synchronous));
  RecordProperty("subharmonic", static_cast<int>(periodic));
  EXPECT_LE(synchronous, recordings() / 40);
  EXPECT_LE(periodic, recordings() / 20);
}

TEST(UnsteadyRecording, ALineBesideAFractionOfTheSpeedHasNoPeriod) {
  // A fraction of the speed, and how many widths of a bin the line stands beside it.
  for (const double fraction : {1 / 2.0, -2 / 5.0})
    for (const double bins : {0.0, 0.2, -5.3})
      for (const double wander : {0.0, 1.0}) {
        Unsteady put{.speed_wander = 2e-3 * wander, .amplitude_wander = 0.02 * wander};
        put.turns = 60;
        put.other_order = fraction + bins / put.turns;
        put.other_share = 0.05;
        const Verdict verdict = judge(recorded(put, 7));
        EXPECT_EQ(verdict.motion, bins == 0 ? MeasuredClass::subharmonic : MeasuredClass::quasi_periodic)
            << put.other_order << " " << wander;
      }
}

TEST(UnsteadyRecording, OrdersLieWithinTheirUncertaintiesWhereMarksAreRoundedToReadings) {
  // Marks of sharp edges are known to a reading, and so is the angle to which orders refer.
  unsigned inside = 0, far = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(3000 + seed);
    put.speed_wander = put.amplitude_wander = 0;
    put.noise_share = 1e-3;
    put.other_order = 0.4142;
    put.other_share = 0.3;
    for (const DiscreteLine& line : judge(recorded(put, seed)).discrete_lines)
      if (const double off = std::abs(line.order - put.other_order); off < 0.5 / put.turns) {
        inside += off <= 2 * line.order_uncertainty;
        far += line.order_uncertainty > 0.05 / put.turns;
      }
  }
  RecordProperty("inside", static_cast<int>(inside));
  EXPECT_GE(inside, recordings() * 95 / 100);
  EXPECT_LE(far, recordings() / 20);
}

}  // namespace
}  // namespace rubsweep::scope
