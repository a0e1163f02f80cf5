#include "rubsweep/measurement/scope/slow_modulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measurement/scope/samples.hpp"

namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A circle that grows by a share, with a line of another order.
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

TEST(SlowModulation, AMotionThatGrowsIsLevelled) {
  const Levelled levelled = without_slow_modulation(moved(40, 0.05, 0, 0), samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, moved(40, 0, 0, 0)), 1e-3);
  EXPECT_NEAR(levelled.modulation_m, 0.05 / std::sqrt(12), 1e-3);
}

TEST(SlowModulation, LinesOfOtherOrdersStay) {
  for (const double order : {0.5, 0.41, -0.3, 2.2}) {
    const auto as_put = moved(40, 0, order, 0.02);
    const Levelled levelled = without_slow_modulation(as_put, samples, {.most_order = 8});
    EXPECT_LT(farthest_apart(levelled.samples, as_put), 0.005) << order;
    EXPECT_LT(levelled.modulation_m, 0.003) << order;
  }
}

TEST(SlowModulation, AMotionThatChangesTooMuchIsLeftAsItIs) {
  const auto growing = moved(40, 1, 0, 0);
  const Levelled levelled = without_slow_modulation(growing, samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, growing), 1e-12);
  EXPECT_LT(levelled.modulation_m, 1e-12);
  EXPECT_NEAR(levelled.refused_m, 1 / std::sqrt(12), 0.02);
}

TEST(SlowModulation, TheBoundsAreThoseThatAreAskedFor) {
  // A growth by a share g is a root mean square of g / sqrt(12).
  for (const double most : {0.003, 0.02, 0.2})
    for (const double beside : {0.9, 1.1}) {
      const double modulation = most * beside;
      const Levelled levelled = without_slow_modulation(moved(40, modulation * std::sqrt(12), 0, 0), samples,
                                                        {.most_order = 8, .most_modulation = most});
      EXPECT_NEAR(beside < 1 ? levelled.modulation_m : levelled.refused_m, modulation, 0.05 * modulation);
      EXPECT_EQ(beside < 1 ? levelled.refused_m : levelled.modulation_m, 0);
    }
}

TEST(SlowModulation, AStrongHalfOrderStaysWhereTurnsAreLevelled) {
  const auto as_put = moved(41, 0, 0.5, 0.8);
  const Levelled levelled = without_slow_modulation(as_put, samples, {.most_order = 8, .repeats = 2});
  EXPECT_LT(farthest_apart(levelled.samples, as_put), 1e-9);
}

TEST(SlowModulation, ACentreThatDriftsIsNoModulation) {
  auto drifting = moved(40, 0, 0, 0);
  for (std::size_t k = 0; k < drifting.size(); ++k) drifting[k] += 0.3 * static_cast<double>(k) / 5120;
  const Levelled levelled = without_slow_modulation(drifting, samples, {.most_order = 8});
  EXPECT_LT(farthest_apart(levelled.samples, moved(40, 0, 0, 0)), 0.2);
  EXPECT_LT(levelled.modulation_m, 1e-3);
}

}  // namespace
}  // namespace rubsweep::scope
