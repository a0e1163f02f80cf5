#include "rubsweep/fit/ramp_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/error.hpp"

namespace rubsweep::fit {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

const Ramp steady{.from_hz = 10, .rate_hz_per_s = 0};

/// Mean over two turns about t = 0 of t^3 + t^4 times e^{-2i phi}, or of itself, by the midpoint rule.
Complex mean_of(bool mirrored) {
  constexpr int steps = 20'000;
  Complex sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = 0.1 * (2.0 * (k + 0.5) / steps - 1);
    const double value = std::pow(t, 3) + std::pow(t, 4);
    sum +=
        value * (mirrored ? std::polar(1.0, -2 * 2 * pi * 10 * t) : Complex(1)) / static_cast<double>(steps);
  }
  return sum;
}

TEST(RampWindow, HasTheMeansOfPolynomials) {
  Complex mean = 0, mirrored = 0;
  for (const WindowNode& node : window_nodes(steady, {0}, 2)) {
    const double value = std::pow(node.t_s, 3) + std::pow(node.t_s, 4);
    mean += node.weight * value;
    mirrored += node.mirrored * value;
  }
  EXPECT_NEAR(std::abs(mean - mean_of(false)), 0, 1e-10);
  EXPECT_NEAR(std::abs(mirrored - mean_of(true)), 0, 1e-10);
}

TEST(RampWindow, OfNoTurnsIsTheInstantItself) {
  const auto nodes = window_nodes(steady, {1, 2}, 0);
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(nodes[1].t_s, 2);
  EXPECT_EQ(nodes[1].weight, 1);
  EXPECT_EQ(nodes[1].point, 1);
}

TEST(RampWindow, ListsTheNodesOfAllWindowsInTime) {
  const auto nodes = window_nodes({.from_hz = 10, .rate_hz_per_s = 1}, {1, 1.05}, 2);
  EXPECT_EQ(nodes.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(nodes, {}, &WindowNode::t_s));
}

TEST(RampWindow, RefusesAStandstill) {
  EXPECT_THROW(window_nodes({.from_hz = 1, .rate_hz_per_s = -1}, {2}, 2), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
