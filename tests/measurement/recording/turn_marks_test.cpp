#include "rubsweep/measurement/recording/turn_marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "measurement/recording/shaft_marks.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

TEST(TurnMarks, MissingMarksAreFilledAndThoseTooManyDropped) {
  const auto truth = turns_s(60, 30, 2);
  auto marks = truth;
  marks.erase(marks.begin() + 40);
  marks.erase(marks.begin() + 20, marks.begin() + 22);
  marks.insert(marks.begin() + 11, (truth[10] * 2 + truth[11]) / 3);
  const TurnMarks numbered = numbered_marks(marks);
  EXPECT_EQ(numbered.filled, 3);
  EXPECT_EQ(numbered.dropped, 1);
  ASSERT_EQ(numbered.t_s.size(), truth.size());
  EXPECT_LT(largest_error(numbered.t_s, truth), 1e-6);
  const TurnMarks untouched = numbered_marks(truth);
  EXPECT_EQ(untouched.t_s, truth);
  EXPECT_EQ(untouched.filled + untouched.dropped, 0);
}

TEST(TurnMarks, ARunUpFromRestHasNoMissingMarks) {
  std::vector<double> marks;
  for (int n = 1; n < 50; ++n) marks.push_back(std::sqrt(2.0 * n / 4));
  EXPECT_EQ(numbered_marks(marks).t_s, marks);
}

TEST(TurnMarks, ManyMarksTooManyAreFound) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  int wrong = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto truth = turns_s(40, 47, 3 * uniform(random));
    auto marks = truth;
    // A surplus mark in seven of ten turns, and marks with a jitter of 1/400 turn.
    for (double& mark : marks) mark += 1e-4 * (uniform(random) - 0.5);
    const auto true_marks = marks;
    for (std::size_t k = 0; k + 1 < truth.size(); ++k)
      if (uniform(random) < 0.7) marks.push_back(truth[k] + uniform(random) * (truth[k + 1] - truth[k]));
    std::ranges::sort(marks);
    const TurnMarks numbered = numbered_marks(marks);
    if (numbered.t_s.size() != truth.size() || largest_error(numbered.t_s, true_marks) > 1e-3) ++wrong;
  }
  EXPECT_LE(wrong, 1);
}

TEST(TurnMarks, AMarkThatIsThereTwiceEveryTurnCountsOnce) {
  std::vector<double> marks;
  for (const double t_s : turns_s(30, 50, 0)) {
    marks.push_back(t_s);
    marks.push_back(t_s + 0.3 * 0.02);
  }
  const TurnMarks numbered = numbered_marks(marks);
  EXPECT_EQ(numbered.dropped, 30);
  EXPECT_EQ(numbered.t_s.size(), 30u);
}

TEST(TurnMarks, ALongGapIsCounted) {
  auto marks = turns_s(80, 50, 0.2);
  const auto truth = marks;
  marks.erase(marks.begin() + 20, marks.begin() + 45);
  EXPECT_LT(largest_error(numbered_marks(marks).t_s, truth), 1e-3);
}

/// A trapezoid of period 1 whose leading edge passes `middle` linearly at every whole number.
double trapezoid(double t, double rest, double top) {
  const double phase = t - std::floor(t + 0.5);
  const double share = std::abs(phase) < 0.02 ? (phase + 0.02) / 0.04 : phase > 0 && phase < 0.1 ? 1 : 0;
  return rest + share * (top - rest);
}

struct Signal {
  std::vector<double> t_s, values;
};

Signal signal_of(double rest, double top) {
  Signal signal;
  for (int k = 0; k < 1000; ++k) {
    signal.t_s.push_back(0.3 + 0.0101 * k);
    signal.values.push_back(trapezoid(signal.t_s.back(), rest, top));
  }
  return signal;
}

TEST(TurnMarksKeyphasor, EdgesAreLocatedBetweenSamples) {
  for (const Mark mark : {Mark::dark, Mark::bright}) {
    const Signal signal = mark == Mark::bright ? signal_of(0, 5) : signal_of(-2, -12);
    const double threshold = middle_threshold(signal.values);
    EXPECT_DOUBLE_EQ(threshold, mark == Mark::bright ? 2.5 : -7);
    const auto marks = mark_times_s(signal.t_s, signal.values, mark, threshold, 0.5);
    ASSERT_EQ(marks.size(), 10u);
    for (std::size_t k = 0; k < marks.size(); ++k) EXPECT_NEAR(marks[k], static_cast<double>(k) + 1, 1e-9);
  }
}

TEST(TurnMarksKeyphasor, HysteresisPassesOverChatter) {
  Signal signal;
  for (const double value : {0., 0., 3., 2.4, 3., 3., 0., 0., 3.}) {
    signal.t_s.push_back(static_cast<double>(signal.t_s.size()));
    signal.values.push_back(value);
  }
  EXPECT_EQ(mark_times_s(signal.t_s, signal.values, Mark::bright, 2.5, 0).size(), 3u);
  EXPECT_EQ(mark_times_s(signal.t_s, signal.values, Mark::bright, 2.5, 1).size(), 2u);
}

TEST(TurnMarksKeyphasor, NoEdgeAcrossAGapAndNoneAtTheBegin) {
  const std::vector<double> t{0, 1, 2, 3, 4, 5}, across{0, 0, NAN, 5, 5, 5}, begun{5, 5, 5, 0, 5, 5};
  EXPECT_TRUE(mark_times_s(t, across, Mark::bright, 2.5, 0).empty());
  EXPECT_EQ(mark_times_s(t, begun, Mark::bright, 2.5, 0), std::vector<double>{3.5});
}

TEST(TurnMarksKeyphasor, ADeadOneIsRefused) {
  EXPECT_THROW(middle_threshold(std::vector<double>(9, 1.0)), ConfigError);
  EXPECT_THROW(middle_threshold(std::vector<double>{}), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
