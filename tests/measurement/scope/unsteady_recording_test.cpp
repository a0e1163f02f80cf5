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

TEST(UnsteadyRecording, ALineThatNoPeriodHasIsFoundOnAMachineThatWanders) {
  unsigned synchronous = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(2000 + seed);
    std::mt19937_64 random(seed);
    put.other_order = std::uniform_real_distribution<double>(0.13, 0.87)(random);
    put.other_share = 0.01 + 0.02 * (seed % 2);
    const Verdict verdict = judge(recorded(put, seed));
    synchronous += verdict.motion == MeasuredClass::synchronous;
  }
  RecordProperty("synchronous", static_cast<int>(synchronous));
  EXPECT_LE(synchronous, recordings() / 40);
}

}  // namespace
}  // namespace rubsweep::scope
