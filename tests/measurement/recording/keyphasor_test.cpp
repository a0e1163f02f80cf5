#include "rubsweep/measurement/recording/keyphasor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

/// A trapezoid of period 1 whose leading edge goes linearly through `middle` at every whole number.
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

TEST(Keyphasor, EdgesAreLocatedBetweenSamples) {
  for (const Mark mark : {Mark::dark, Mark::bright}) {
    const Signal signal = mark == Mark::bright ? signal_of(0, 5) : signal_of(-2, -12);
    const double threshold = middle_threshold(signal.values);
    EXPECT_DOUBLE_EQ(threshold, mark == Mark::bright ? 2.5 : -7);
    const auto marks = mark_times_s(signal.t_s, signal.values, mark, threshold, 0.5);
    ASSERT_EQ(marks.size(), 10u);
    for (std::size_t k = 0; k < marks.size(); ++k) EXPECT_NEAR(marks[k], static_cast<double>(k) + 1, 1e-9);
  }
}

TEST(Keyphasor, HysteresisPassesOverChatter) {
  Signal signal;
  for (const double value : {0., 0., 3., 2.4, 3., 3., 0., 0., 3.}) {
    signal.t_s.push_back(static_cast<double>(signal.t_s.size()));
    signal.values.push_back(value);
  }
  EXPECT_EQ(mark_times_s(signal.t_s, signal.values, Mark::bright, 2.5, 0).size(), 3u);
  EXPECT_EQ(mark_times_s(signal.t_s, signal.values, Mark::bright, 2.5, 1).size(), 2u);
}

TEST(Keyphasor, NoEdgeAcrossAGapAndNoneAtTheBegin) {
  const std::vector<double> t{0, 1, 2, 3, 4, 5}, across{0, 0, NAN, 5, 5, 5}, begun{5, 5, 5, 0, 5, 5};
  EXPECT_TRUE(mark_times_s(t, across, Mark::bright, 2.5, 0).empty());
  EXPECT_EQ(mark_times_s(t, begun, Mark::bright, 2.5, 0), std::vector<double>{3.5});
}

TEST(Keyphasor, ADeadOneIsRefused) {
  EXPECT_THROW(middle_threshold(std::vector<double>(9, 1.0)), ConfigError);
  EXPECT_THROW(middle_threshold(std::vector<double>{}), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
