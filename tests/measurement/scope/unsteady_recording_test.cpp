#include "measurement/scope/unsteady_recording.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "rubsweep/measurement/scope/verdict.hpp"

/// Verdicts on slightly unsteady machines, with and without a fault. RUBSWEEP_LONG tests 200 recordings of
/// each kind.
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

TEST(UnsteadyRecording, AStrongHalfOrderThatSwingsIsFound) {
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
  EXPECT_GE(half, recordings() * 95 / 100);
}

TEST(UnsteadyRecording, AThirdThatSwingsIsFoundAndALineBesideItHasNoPeriod) {
  for (const double bins : {0.0, 0.4, 1.5}) {
    Unsteady put{.speed_wander = 1e-3, .amplitude_wander = 0.03};
    put.turns = 48;
    put.other_order = -1 / 3.0 + bins / put.turns;
    put.other_share = 0.2;
    put.other_swing = 0.2;
    const Verdict verdict = judge(recorded(put, 11));
    EXPECT_EQ(verdict.period.value_or(0), bins == 0 ? 3 : 0) << bins;
  }
}

TEST(UnsteadyRecording, ALineThatNoPeriodHasIsFoundOnAMachineThatWanders) {
  unsigned synchronous = 0, periodic = 0, sure = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(2000 + seed);
    std::mt19937_64 random(seed);
    put.other_order = std::uniform_real_distribution<double>(0.13, 0.87)(random);
    put.other_share = 0.01 + 0.02 * (seed % 2);
    const Verdict verdict = judge(recorded(put, seed));
    synchronous += verdict.motion == MeasuredClass::synchronous;
    periodic += verdict.period.value_or(1) > 1;
    sure += verdict.motion == MeasuredClass::subharmonic;
    EXPECT_EQ(verdict.motion == MeasuredClass::subharmonic_or_torus,
              verdict.period.value_or(1) > 1 && may_be_torus(verdict));
  }
  RecordProperty("synchronous", static_cast<int>(synchronous));
  RecordProperty("subharmonic", static_cast<int>(periodic));
  EXPECT_LE(synchronous, recordings() / 40);
  RecordProperty("surely subharmonic", static_cast<int>(sure));
  EXPECT_LE(periodic, recordings() / 20);
  EXPECT_LE(sure, recordings() / 40);
}

TEST(UnsteadyRecording, ATorusAnEighthOfABinBesideAFractionIsNotSurelyOfItsPeriod) {
  // Weak lines so close to a fraction that noise hides the difference, and strong ones exactly at it.
  unsigned passed = 0, sure = 0, doubted = 0;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    Unsteady put = drawn(5000 + seed);
    put.speed_wander = put.amplitude_wander = 0;
    put.noise_share = 0.06;
    put.other_order = (seed % 2 == 0 ? 2 : 3) / 5.0 + 0.12 / put.turns;
    put.other_share = 0.02;
    const Verdict weak = judge(recorded(put, seed));
    passed += weak.period.value_or(1) > 1;
    sure += weak.motion == MeasuredClass::subharmonic;
    put.other_order = (seed % 2 == 0 ? 2 : 3) / 5.0;
    put.other_share = 0.3;
    const Verdict strong = judge(recorded(put, seed));
    doubted += strong.period != 5 || strong.motion != MeasuredClass::subharmonic;
  }
  RecordProperty("passed", static_cast<int>(passed));
  RecordProperty("sure", static_cast<int>(sure));
  RecordProperty("doubted", static_cast<int>(doubted));
  EXPECT_GT(passed, 0u);
  EXPECT_LE(sure, passed / 20);
  EXPECT_LE(doubted, recordings() / 8);
}

TEST(UnsteadyRecording, ALineBesideAFractionOfTheSpeedHasNoPeriod) {
  // A fraction of the speed, and the distance of the line from it in bins.
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
  // Marks with sharp edges are known to one reading only, and so is the reference angle of the orders.
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

/// Counts lines with 30 % of 1X whose measured values agree with the true ones.
struct Inside {
  unsigned found = 0, orders = 0, amplitudes = 0;  ///< found within two uncertainties
  std::vector<double> bins{}, shares{};            ///< uncertainties of orders and of amplitudes

  void look(const Unsteady& put, unsigned seed) {
    const Verdict verdict = judge(recorded(put, seed));
    const auto away = [&](const DiscreteLine& line) { return std::abs(line.order - put.other_order); };
    const auto line = std::ranges::min_element(verdict.discrete_lines, {}, away);
    if (line == verdict.discrete_lines.end() || away(*line) > 1.0 / put.turns) return;
    const double size_m = 1e-4 * put.other_share;
    ++found;
    orders += away(*line) <= 2 * line->order_uncertainty;
    amplitudes += std::abs(line->amplitude_m - size_m) <= 2 * line->amplitude_uncertainty_m;
    bins.push_back(line->order_uncertainty * put.turns);
    shares.push_back(line->amplitude_uncertainty_m / size_m);
  }
  /// Expects 95 % of the true values inside their intervals; of a few values at most one may be outside.
  void expect_most(const std::string& name, double most_uncertainty = 1.2e-3) {
    const unsigned least = std::min(found - 1, (found * 95 + 99) / 100);
    EXPECT_GE(found, recordings() * 9 / 10) << name;
    EXPECT_GE(orders, least) << name;
    EXPECT_GE(amplitudes, least) << name;
    for (auto* values : {&bins, &shares}) std::ranges::nth_element(*values, values->begin() + found / 2);
    EXPECT_LT(bins[found / 2], most_uncertainty) << name;
    EXPECT_LT(shares[found / 2], most_uncertainty) << name;
    testing::Test::RecordProperty(
        name, fmt::format("{} found, orders {}, amplitudes {}, medians {:.1e} bins, {:.1e}", found, orders,
                          amplitudes, bins[found / 2], shares[found / 2]));
  }
};

/// A recording with a line at an order that belongs to no period. Its marks have readings on their edges.
Unsteady line_between(unsigned seed) {
  std::mt19937_64 random(9000 + seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Unsteady put = drawn(3000 + seed);
  put.speed_wander = put.amplitude_wander = 0;
  put.noise_share = 1e-3 * std::pow(10, uniform(random));
  put.other_order = 0.405 + 0.02 * uniform(random);
  put.other_share = 0.3;
  put.edge_readings = 2 + 2 * uniform(random);
  // Short recordings, where only a few are tested.
  if (recordings() < 200) put.turns = 24 + static_cast<int>(seed);
  return put;
}

TEST(UnsteadyRecording, ALineBetweenTheBinsIsWithinItsUncertainties) {
  Inside sharp, soft, near, coarse, wandering, rounded, noisy;
  for (unsigned seed = 0; seed < recordings(); ++seed) {
    const Unsteady as_put = line_between(seed);
    Unsteady put = as_put;
    put.edge_readings = 0;
    put.noise_share = 1e-3;
    sharp.look(put, seed);
    soft.look(as_put, seed);
    put = as_put;
    put.near_bins = (seed % 2 == 0 ? 2.2 : -2.2) * (1 + 0.15 * (seed % 9));
    put.near_share = 0.1 + 0.06 * (seed % 11);
    near.look(put, seed);
    // Quantisation with twelve bits over 0.5 to 5 mm.
    put = as_put;
    put.noise_share = 1e-4;
    put.step_um = 0.125 * (1 + seed % 10);
    coarse.look(put, seed);
    put = as_put;
    put.speed_wander = drawn(seed).speed_wander;
    wandering.look(put, seed);
    // Marks rounded to readings, between which the speed swings: fast lines lose amplitude.
    put = as_put;
    put.edge_readings = 0;
    put.other_order -= 3;
    put.readings_per_turn = 32 + 4 * (seed % 3);
    put.turns = 120 + static_cast<int>(seed % 40);
    put.speed_wander = 2.2e-3;
    put.speed_cycles = 2 + 0.5 * (seed % 4);
    rounded.look(put, seed);
    put = as_put;
    put.mark_noise_v = 0.25;
    noisy.look(put, seed);
  }
  sharp.expect_most("sharp_marks");
  soft.expect_most("soft_marks");
  near.expect_most("line_near");
  coarse.expect_most("twelve_bits");
  wandering.expect_most("speed_wanders");
  rounded.expect_most("speed_wanders_beside_sharp_marks", 0.1);
  noisy.expect_most("noise_of_the_mark", 5e-3);
}

}  // namespace
}  // namespace rubsweep::scope
