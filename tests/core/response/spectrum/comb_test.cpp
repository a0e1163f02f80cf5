#include "rubsweep/core/response/spectrum/comb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/response/spectrum/comb_samples.hpp"
#include "core/response/synthetic_motion.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::response::testing {
namespace {

using TimeFunction = std::function<Complex(double)>;

std::optional<spectrum::Comb> comb_of(const TimeFunction& z) {
  spectrum::SpectrumWorkspace workspace;
  return spectrum::find_comb(sample(z, 0, comb_turns, comb_samples_per_turn), comb_samples_per_turn,
                             workspace);
}

/// Motion with lines at 1 + k spacing and the given amplitudes, k = first, first + 1, ...
TimeFunction comb(double spacing, int first, std::vector<double> amplitudes) {
  return [=](double turn) {
    Complex sum = 0;
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      sum += amplitudes[i] * phasor(1 + (first + static_cast<int>(i)) * spacing, turn);
    }
    return sum;
  };
}

void expect_closed(const TimeFunction& z, double spacing) {
  const auto found = comb_of(z);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->closed);
  EXPECT_NEAR(found->spacing, spacing, 1e-8);
}

TEST(CombFind, ReadsTheSpacingOfACombToEightDigits) {
  for (const double spacing : {0.1813, 0.3333, 0.515, 0.6871, 0.94, 1.6180339887, 2.3}) {
    SCOPED_TRACE(spacing);
    expect_closed(comb(spacing, -3, {0.05, 0.2, 0.5, 0.8, 0.1, 0.03}), spacing);
  }
}

TEST(CombFind, HoldsAllTheEnergyOfACombThatIsWideEnough) {
  EXPECT_NEAR(comb_of(comb(0.515, -2, {0.2, 0.5, 0.8, 0.1}))->energy_share, 1, 1e-3);
  // A spacing of 0.0745 over 128 turns is 9.5 bins, so the lines overlap.
  const auto narrow = comb_of(comb(0.0745, -2, {0.2, 0.5, 0.8, 0.1}));
  EXPECT_TRUE(narrow->closed);
  EXPECT_EQ(narrow->energy_share, 0);
}

TEST(CombFind, IsNotMisledByTheLargestLine) {
  // The two largest lines other than 1X are two and three spacings away from each other.
  expect_closed(comb(0.2317, -2, {0.9, 0.3, 0.8}), 0.2317);
  expect_closed(comb(0.2317, -3, {0.9, 0, 0.3, 0.8}), 0.2317);
  // 1X itself may be missing.
  expect_closed(comb(0.4, -1, {0.9, 0, 0.5}), 0.4);
}

TEST(CombFind, OfADoubledPeriodIsHalf) {
  const double spacing = 0.6793;
  const auto main = comb(spacing, -2, {0.2, 0.8, 0.3});
  const auto with_halves = [&](double amplitude) {
    return [=](double turn) { return main(turn) + amplitude * phasor(1 - spacing / 2, turn); };
  };
  expect_closed(with_halves(0.02), spacing / 2);
  expect_closed(with_halves(0.002), spacing / 2);
  // Below a thousandth of the orbit's size, it is not significant.
  expect_closed(with_halves(0.0005), spacing);
}

TEST(CombFind, OfAWhirlAtOneFrequencyIsItsDistanceFromTheShafts) {
  expect_closed([](double turn) { return 0.7 * phasor(-0.83, turn); }, 1.83);
  expect_closed([](double turn) { return 0.7 * phasor(-0.83, turn) + 0.2 * phasor(1, turn); }, 1.83);
}

TEST(CombFind, DoesNotCloseWithAThirdFrequency) {
  const auto found = comb_of([](double turn) {
    return 0.8 * phasor(1, turn) + 0.6 * phasor(0.3819660113, turn) + 0.1 * phasor(0.7071067812, turn);
  });
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->closed);
  // The comb of the largest line lacks 1 % of the energy: 0.1^2 of 0.8^2 + 0.6^2 + 0.1^2.
  EXPECT_NEAR(found->spacing, 0.6180339887, 1e-3);
  EXPECT_NEAR(found->energy_share, 1 / 1.01, 1e-3);
}

TEST(CombFind, DoesNotCloseWhileItStillGrowsOrShrinks) {
  const auto settling = [](double rate) {
    return comb_of([rate](double turn) {
      return 0.8 * phasor(1, turn) + 0.3 * std::exp(rate * turn) * phasor(0.4, turn);
    });
  };
  EXPECT_FALSE(settling(-1e-3)->closed);
  EXPECT_FALSE(settling(1e-4)->closed);
  EXPECT_TRUE(settling(-1e-5)->closed);
  EXPECT_NEAR(settling(-1e-3)->spacing, 0.6, 1e-3);
}

TEST(CombFind, DoesNotCloseInNoiseNorChaos) {
  std::mt19937 bits(1);
  std::normal_distribution<double> normal;
  std::vector<Complex> z(comb_turns * comb_samples_per_turn);
  for (auto& value : z) value = {normal(bits), normal(bits)};
  spectrum::SpectrumWorkspace workspace;
  const auto noise = spectrum::find_comb(z, comb_samples_per_turn, workspace);
  EXPECT_FALSE(noise->closed);
  EXPECT_LT(noise->energy_share, 0.9);

  std::vector<double> henon{0.1, 0.2};
  for (int k = 0; k < comb_turns; ++k)
    henon.push_back(1 - 1.4 * henon.back() * henon.back() + 0.3 * henon[henon.size() - 2]);
  const auto chaos = comb_of([&henon](double turn) {
    const auto k = static_cast<std::size_t>(turn);
    const double blend = turn - static_cast<double>(k);
    return phasor(1, turn) + 0.4 * (henon[k] + blend * (henon[k + 1] - henon[k])) * phasor(0.4, turn);
  });
  EXPECT_FALSE(chaos->closed);
}

TEST(CombFind, DoesNotLookForPeriodsAboveAQuarterOfTheSamples) {
  EXPECT_FALSE(comb_of(comb(1.0 / 33, -1, {0.3, 0.8}))->closed);
  EXPECT_TRUE(comb_of(comb(1.0 / 31, -1, {0.3, 0.8}))->closed);
}

TEST(CombFind, NeedsAMotionThatMovesInTheRotatingFrame) {
  EXPECT_FALSE(comb_of([](double) { return Complex(0); }));
  const auto circle = comb_of([](double turn) { return 0.8 * phasor(1, turn); });
  // In the rotating frame only rounding errors move, and these do not return.
  EXPECT_FALSE(circle && circle->closed);
}

TEST(CombFind, RefusesSamplesThatDoNotFillThirtyTwoTurns) {
  spectrum::SpectrumWorkspace workspace;
  EXPECT_THROW(spectrum::find_comb(std::vector<Complex>(31 * 64), 64, workspace), SolverError);
  EXPECT_THROW(spectrum::find_comb(std::vector<Complex>(64 * 64 + 1), 64, workspace), SolverError);
  EXPECT_THROW(spectrum::find_comb(std::vector<Complex>(300), 3, workspace), SolverError);
}

std::optional<spectrum::SpectralLine> largest_of(const std::function<Complex(double)>& z, double spacing) {
  return spectrum::largest_comb_line(sample(z, 0, comb_turns, comb_samples_per_turn), comb_samples_per_turn,
                                     spacing);
}

TEST(CombLargest, HasTheOrderAndAmplitudeThatStandBetweenTwoBins) {
  // 1 - 2 * 0.8431 is half a bin away from the nearest bin, where a plain spectrum shows 64 % of the
  // amplitude.
  for (const double spacing : {0.8431, 1.8357, 2.6857}) {
    const auto line = largest_of(
        [=](double turn) { return 0.2 * phasor(1, turn) + 0.9 * phasor(1 - 2 * spacing, turn); }, spacing);
    ASSERT_TRUE(line);
    EXPECT_DOUBLE_EQ(line->order, 1 - 2 * spacing);
    EXPECT_NEAR(line->amplitude_m, 0.9, 1e-6);
  }
}

TEST(CombLargest, IsTheLargerOfTwoThatBinsWouldSwap) {
  // In bins of 1/128, the first line is on a bin and the second one half a bin off: 0.9 compared with 0.64.
  const double spacing = 0.5 + 1.0 / 512;
  const auto line = largest_of(
      [=](double turn) { return 0.9 * phasor(1, turn) + 1.0 * phasor(1 + 2 * spacing, turn); }, spacing);
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->order, 1 + 2 * spacing);
  EXPECT_NEAR(line->amplitude_m, 1, 1e-6);
}

TEST(CombLargest, IsNeverTheMean) {
  const auto line = largest_of([](double turn) { return 2.0 + 0.3 * phasor(1.5, turn); }, 0.5);
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->order, 1.5);
  EXPECT_NEAR(line->amplitude_m, 0.3, 1e-4);
}

TEST(CombLargest, OfRestIsNone) {
  EXPECT_FALSE(largest_of([](double) { return Complex(0); }, 0.5));
}

}  // namespace
}  // namespace rubsweep::response::testing
