// Published numbers for other systems, reproduced with the functions that evaluate the motions of a rotor.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "rubsweep/maps/basin/basin_entropy.hpp"
#include "rubsweep/maps/basin/low_discrepancy.hpp"

namespace rubsweep::basin {
namespace {

constexpr double pi = std::numbers::pi;

/// Grid of labels; both axes include both ends.
template <class Label>
LabelGrid grid_over(std::size_t side, double x0, double x1, double y0, double y1, const Label& label) {
  LabelGrid grid{side, side, {}};
  const auto at = [&](double from, double to, std::size_t i) {
    return from + (to - from) * static_cast<double>(i) / static_cast<double>(side - 1);
  };
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) grid.labels.push_back(label(at(x0, x1, i), at(y0, y1, j)));
  }
  return grid;
}

double share_of(const LabelGrid& grid, int label) {
  return fraction(static_cast<std::size_t>(std::ranges::count(grid.labels, label)), grid.labels.size());
}

/// Attractors.jl: of 100 x 100 initial states on [-2, 2]^2 a share of 0.575 diverges.
TEST(Published, HenonsMapDivergesFromMoreThanHalf) {
  const LabelGrid grid = grid_over(100, -2, 2, -2, 2, [](double x, double y) {
    for (int i = 0; i < 1000; ++i) {
      const double next = 1 - 1.4 * x * x + y;
      y = 0.3 * x;
      x = next;
      if (!(std::abs(x) < 1e3)) return 0;
    }
    return 1;
  });
  EXPECT_NEAR(share_of(grid, 0), 0.575, 0.005);
  EXPECT_NEAR(share_of(grid, 1), 0.425, 0.005);
}

/// Grebogi, McDonald, Ott and Yorke 1983: an uncertainty exponent of about 0.2.
int grebogi_label(double theta, double x) {
  for (int i = 0; i < 100; ++i) {
    const double next = theta + 1.32 * std::sin(2 * theta) - 0.9 * std::sin(4 * theta) - x * std::sin(theta);
    x = -0.3 * std::cos(theta);
    theta = next;
  }
  return std::cos(theta) > 0;
}

TEST(Published, GrebogisMapHasABoundaryThatIsFractal) {
  const auto exponent = uncertainty_exponent(grid_over(251, 0, 2 * pi, -0.5, 0.5, grebogi_label));
  ASSERT_TRUE(exponent);
  EXPECT_GT(exponent->value, 0.2);
  EXPECT_LT(exponent->value, 0.3);
  const BasinEntropy entropy = basin_entropy(grid_over(300, 0, 2 * pi, -0.5, 0.5, grebogi_label), 6);
  EXPECT_GT(entropy.all, 0.395);
  EXPECT_LT(entropy.all, 0.425);
  EXPECT_GT(entropy.boundary, 0.595);
  EXPECT_LT(entropy.boundary, 0.615);
}

TEST(Published, NewtonsMapForThreeRoots) {
  const auto exponent = uncertainty_exponent(grid_over(300, -1, 1, -1, 1, [](double x, double y) {
    std::complex<double> z(x, y);
    for (int i = 0; i < 200 && std::abs(z) > 0; ++i) z -= (z * z * z - 1.0) / (3.0 * z * z);
    return static_cast<int>(std::lround(std::arg(z) / (2 * pi / 3)));
  }));
  ASSERT_TRUE(exponent);
  EXPECT_GT(exponent->value, 0.55);
  EXPECT_LT(exponent->value, 0.65);
}

using State = std::array<double, 2>;

/// Classical Runge-Kutta method for x'' = force(t, x, x').
template <class Force>
State integrated(State y, double from, double to, int steps, const Force& force) {
  const double h = (to - from) / steps;
  const auto rate = [&](double t, const State& s) { return State{s[1], force(t, s[0], s[1])}; };
  const auto moved = [](const State& s, const State& k, double by) {
    return State{s[0] + by * k[0], s[1] + by * k[1]};
  };
  for (int i = 0; i < steps; ++i) {
    const double t = from + h * i;
    const State a = rate(t, y), b = rate(t + h / 2, moved(y, a, h / 2)),
                c = rate(t + h / 2, moved(y, b, h / 2)), d = rate(t + h, moved(y, c, h));
    for (std::size_t k = 0; k < 2; ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  return y;
}

/// bSTAB (Stender and Hoffmann): five attractors of x'' + 0.08 x' + x^3 = 0.2 cos t.
TEST(Published, FiveAttractorsOfDuffingsOscillator) {
  constexpr std::size_t samples = 1500;
  constexpr std::array<State, 5> templates{
      {{-0.21, 0.02}, {1.05, 0.77}, {-0.67, 0.02}, {-0.46, 0.30}, {-0.43, 0.12}}};
  constexpr std::array published{0.2027, 0.4950, 0.0288, 0.0257, 0.2478};
  const auto force = [](double t, double x, double v) { return 0.2 * std::cos(t) - 0.08 * v - x * x * x; };
  // State after some turns of the forcing; one section of each attractor is its template.
  const auto after = [&](State y, int turns) { return integrated(y, 0, 2 * pi * turns, 60 * turns, force); };
  std::array<State, 5> orbits;
  for (std::size_t k = 0; k < 5; ++k) orbits[k] = after(templates[k], 60);
  std::array<std::size_t, 5> counts{};
  for (std::size_t i = 0; i < samples; ++i) {
    const auto point = low_discrepancy_point(i, 2);
    State y = after({-1 + 2 * point[0], -0.5 + 1.5 * point[1]}, 60);
    // Within six turns, a motion of period 1, 2 or 3 passes the section that its template passed.
    double best = 1e300;
    std::size_t nearest = 0;
    for (int turn = 0; turn < 6; ++turn) {
      for (std::size_t k = 0; k < 5; ++k) {
        const double distance = std::hypot(y[0] - orbits[k][0], y[1] - orbits[k][1]);
        if (distance < best) best = distance, nearest = k;
      }
      y = after(y, 1);
    }
    EXPECT_LT(best, 0.05);
    ++counts[nearest];
  }
  for (std::size_t k = 0; k < 5; ++k) {
    const double share = fraction(counts[k], samples);
    EXPECT_NEAR(share, published[k], 3 * standard_error(published[k], samples)) << k;
  }
}

/// bSTAB: for the pendulum y'' = -0.1 y' + 0.5 - sin y a share of 0.152 comes to rest, the others rotate.
TEST(Published, PendulumRestsOrRotates) {
  constexpr std::size_t samples = 2000;
  const auto force = [](double, double y, double v) { return -0.1 * v + 0.5 - std::sin(y); };
  std::size_t rest = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto point = low_discrepancy_point(i, 2);
    const State end =
        integrated({-pi + std::asin(0.5) + 2 * pi * point[0], -10 + 20 * point[1]}, 0, 100, 1500, force);
    if (std::abs(end[1]) < 1) ++rest;
  }
  const double share = fraction(rest, samples);
  EXPECT_NEAR(share, 0.152, 3 * standard_error(0.152, samples));
}

/// bSTAB's friction oscillator: x'' + 0.1 x' + x + sgn(v) mu(v) = 0 with v = x' - belt and mu = 0.5 + 0.5
/// exp(-2 |v|), where sticking friction is at most 1. It rests on the sliding belt at x = mu(belt), x' = 0.
struct FrictionOscillator {
  double belt = 0;

  static double coefficient(double slip) { return 0.5 + 0.5 * std::exp(-2 * std::abs(slip)); }
  double rest() const { return coefficient(belt); }
  bool sticks(double x) const { return std::abs(x + 0.1 * belt) <= coefficient(0); }

  /// Runs until the mass sticks, comes within `near` of the rest position, or the time reaches `end`.
  enum class Ending { sticks, rests, neither };
  Ending run(State& y, double end, double near) const {
    constexpr double step = 0.02;
    for (double t = 0; t < end; t += step) {
      const double sign = y[1] < belt ? -1 : 1;
      y = integrated(y, 0, step, 1,
                     [&](double, double x, double v) { return -0.1 * v - x - sign * coefficient(v - belt); });
      if ((y[1] - belt) * sign < 0 && sticks(y[0])) return Ending::sticks;
      if (std::hypot(y[0] - rest(), y[1]) < near) return Ending::rests;
    }
    return Ending::neither;
  }
};

/// bSTAB: from [-2, 2] x [0, 2] a share of 0.312 comes to rest at a belt speed of 1.5. All motions that stick
/// once leave the belt at the same place, so they are one attractor.
TEST(Published, FrictionOscillatorRestsOrSticksAndSlips) {
  constexpr std::size_t samples = 2000;
  const FrictionOscillator oscillator{1.5};
  State leaves{FrictionOscillator::coefficient(0) - 0.1 * oscillator.belt, oscillator.belt - 1e-9};
  EXPECT_EQ(oscillator.run(leaves, 100, 0.05), FrictionOscillator::Ending::sticks);
  std::size_t rest = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto point = low_discrepancy_point(i, 2);
    State y{-2 + 4 * point[0], 2 * point[1]};
    const auto ending = oscillator.run(y, 1000, 0.05);
    EXPECT_NE(ending, FrictionOscillator::Ending::neither);
    if (ending == FrictionOscillator::Ending::rests) ++rest;
  }
  EXPECT_NEAR(fraction(rest, samples), 0.312, 3 * standard_error(0.312, samples));
}

/// The rest position is stable where 0.1 - exp(-2 belt) > 0: below this speed no nearby motion approaches it,
/// above it all do.
TEST(Published, FrictionOscillatorsRestBecomesStableAtItsClosedForm) {
  const auto coming_nearer = [](double belt) {
    const FrictionOscillator oscillator{belt};
    std::size_t nearer = 0;
    constexpr std::size_t samples = 20;
    for (std::size_t i = 0; i < samples; ++i) {
      const double angle = 2 * pi * low_discrepancy_point(i, 1).front(), radius = 1e-3;
      State y{oscillator.rest() + radius * std::cos(angle), radius * std::sin(angle)};
      oscillator.run(y, 200, 0);
      if (std::hypot(y[0] - oscillator.rest(), y[1]) < radius) ++nearer;
    }
    return fraction(nearer, samples);
  };
  const double onset = 0.5 * std::log(10);
  EXPECT_NEAR(onset, 1.15129, 5e-6);
  EXPECT_EQ(coming_nearer(onset - 0.005), 0);
  EXPECT_EQ(coming_nearer(onset + 0.005), 1);
}

}  // namespace
}  // namespace rubsweep::basin
