#include "rubsweep/measurement/scope/repeating_angles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measurement/scope/samples.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

TEST(RepeatingAnglesMeanPeriod, TheLastWholePeriodsCount) {
  const std::vector<Complex> samples{9, 1, 2, 3, 5};
  const auto whole = whole_periods(samples, 2);
  ASSERT_EQ(whole.size(), 4u);
  EXPECT_EQ(mean_period(whole, 2), (std::vector<Complex>{2, 3.5}));
}

TEST(RepeatingAnglesMeanPeriod, LinesAreThoseThatWerePutIn) {
  std::vector<Complex> period;
  for (int k = 0; k < 40; ++k) {
    const double phase = 2 * std::numbers::pi * k / 40;
    period.push_back(Complex(3, 1) + std::polar(2.0, 0.4 + 5 * phase) + std::polar(0.5, -1 - 3 * phase));
  }
  const auto lines = lines_of_period(period, 6);
  ASSERT_EQ(lines.size(), 13u);
  for (int k = -6; k <= 6; ++k) {
    const Complex truth = k == 0    ? Complex(3, 1)
                          : k == 5  ? std::polar(2.0, 0.4)
                          : k == -3 ? std::polar(0.5, -1.0)
                                    : 0;
    EXPECT_LT(std::abs(lines[static_cast<std::size_t>(k + 6)] - truth), 1e-14) << k;
  }
}

constexpr int turns = 32;

/// A 1/2 subharmonic at a shaft angle, in turns.
Complex motion_at(double angle) {
  return std::polar(80.0, 2 * pi * angle) + std::polar(20.0, 1 - 4 * pi * angle) +
         std::polar(30.0, pi * angle);
}

/// Error of the angles, up to 0.01 turns; its mean over the marks is zero.
double error_at(double angle) {
  const double x = 2 * angle / turns - 1;
  return 0.006 * x + 0.004 * (1.5 * x * x - 0.53125);
}

std::vector<Complex> motion(bool wrong) {
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples; ++k) {
    const double angle = static_cast<double>(k) / samples;
    z.push_back(motion_at(wrong ? angle - error_at(angle) : angle));
  }
  return z;
}

recording::AngleDoubt doubt(double room, int degree) {
  return {std::vector<double>(turns + 1, -room), std::vector<double>(turns + 1, room), degree};
}

/// Largest difference of the samples. An eighth of a turn at both ends is left out, because the samples there
/// come from one period away and have another angular error.
double largest_difference(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double largest = 0;
  for (std::size_t k = samples / 8; k + samples / 8 < a.size(); ++k)
    largest = std::max(largest, std::abs(a.at(k) - b.at(k)));
  return largest;
}

TEST(RepeatingAngles, FindTheMotionAtItsTrueAngles) {
  const auto wrong = motion(true);
  EXPECT_GT(largest_difference(wrong, motion(false)), 5);
  EXPECT_LT(largest_difference(at_repeating_angles(wrong, samples, 2, 8, doubt(0.02, 2)), motion(false)),
            0.01);
  EXPECT_LT(largest_difference(at_repeating_angles(wrong, samples, 2, 8, doubt(0.02, 3)), motion(false)),
            0.01);
}

TEST(RepeatingAngles, AMotionAtItsTrueAnglesStays) {
  const auto true_motion = motion(false);
  EXPECT_LT(largest_difference(at_repeating_angles(true_motion, samples, 2, 8, doubt(0.02, 2)), true_motion),
            1e-3);
}

TEST(RepeatingAngles, WithoutDoubtNothingMoves) {
  const auto wrong = motion(true);
  EXPECT_EQ(at_repeating_angles(wrong, samples, 2, 8, {}), wrong);
}

TEST(RepeatingAngles, TheMarksBoundTheShift) {
  // With a tenth of the required doubt, nine tenths of the error remain.
  const auto wrong = motion(true);
  const auto moved = at_repeating_angles(wrong, samples, 2, 8, doubt(0.0008, 2));
  const double all = largest_difference(wrong, motion(false));
  EXPECT_GT(largest_difference(moved, motion(false)), 0.8 * all);
  EXPECT_GT(largest_difference(moved, wrong), 0.01 * all);
}

TEST(RepeatingAngles, APeriodThatIsNoneLeavesWhatDoesNotRepeat) {
  // The half order is not part of a period of one turn and stays.
  const auto wrong = motion(true);
  const auto moved = at_repeating_angles(wrong, samples, 1, 8, doubt(0.02, 2));
  double apart = 0;
  for (std::size_t k = 0; k + samples < moved.size(); ++k)
    apart = std::max(apart, std::abs(moved[k + samples] - moved[k]));
  EXPECT_GT(apart, 50);
}

/// A circular motion that grows by `growth`, with a line of another order.
std::vector<Complex> moved(int turns, double growth, double order, double amplitude) {
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples; ++k) {
    const double angle = 2 * pi * k / samples;
    z.push_back((1 + growth * (static_cast<double>(k) / (turns * samples) - 0.5)) * std::polar(1.0, angle) +
                amplitude * std::polar(1.0, order * angle));
  }
  return z;
}

double farthest_apart(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST(RepeatingAnglesSlowModulation, AMotionThatGrowsIsLevelled) {
  const Levelled levelled = without_slow_modulation(moved(40, 0.05, 0, 0), samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, moved(40, 0, 0, 0)), 1e-3);
  EXPECT_NEAR(levelled.modulation_m, 0.05 / std::sqrt(12), 1e-3);
}

TEST(RepeatingAnglesSlowModulation, LinesOfOtherOrdersStay) {
  for (const double order : {0.5, 0.41, -0.3, 2.2}) {
    const auto as_put = moved(40, 0, order, 0.02);
    const Levelled levelled = without_slow_modulation(as_put, samples, {.most_order = 8});
    EXPECT_LT(farthest_apart(levelled.samples, as_put), 0.005) << order;
    EXPECT_LT(levelled.modulation_m, 0.003) << order;
  }
}

TEST(RepeatingAnglesSlowModulation, AMotionThatChangesTooMuchIsLeftAsItIs) {
  const auto growing = moved(40, 1, 0, 0);
  const Levelled levelled = without_slow_modulation(growing, samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, growing), 1e-12);
  EXPECT_LT(levelled.modulation_m, 1e-12);
  EXPECT_NEAR(levelled.refused_m, 1 / std::sqrt(12), 0.02);
}

TEST(RepeatingAnglesSlowModulation, TheBoundsAreThoseThatAreAskedFor) {
  // Linear growth by a share g has the root mean square g / sqrt(12).
  for (const double most : {0.003, 0.02, 0.2})
    for (const double beside : {0.9, 1.1}) {
      const double modulation = most * beside;
      const Levelled levelled = without_slow_modulation(moved(40, modulation * std::sqrt(12), 0, 0), samples,
                                                        {.most_order = 8, .most_modulation = most});
      EXPECT_NEAR(beside < 1 ? levelled.modulation_m : levelled.refused_m, modulation, 0.05 * modulation);
      EXPECT_EQ(beside < 1 ? levelled.refused_m : levelled.modulation_m, 0);
    }
}

TEST(RepeatingAnglesSlowModulation, AStrongHalfOrderStaysWhereTurnsAreLevelled) {
  const auto as_put = moved(41, 0, 0.5, 0.8);
  const Levelled levelled = without_slow_modulation(as_put, samples, {.most_order = 8, .repeats = 2});
  EXPECT_LT(farthest_apart(levelled.samples, as_put), 1e-9);
}

TEST(RepeatingAnglesSlowModulation, ACentreThatDriftsIsNoModulation) {
  auto drifting = moved(40, 0, 0, 0);
  for (std::size_t k = 0; k < drifting.size(); ++k) drifting[k] += 0.3 * static_cast<double>(k) / 5120;
  const Levelled levelled = without_slow_modulation(drifting, samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, moved(40, 0, 0, 0)), 0.2);
  EXPECT_LT(levelled.modulation_m, 1e-3);
}

}  // namespace
}  // namespace rubsweep::scope
