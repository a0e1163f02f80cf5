#include "rubreport/orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/rubreport/decoded.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

/// An ellipse of 3 by 1 mm over two turns, with a wall that is touched during a few samples.
SettledOrbit ellipse() {
  SettledOrbit orbit;
  orbit.first_revolution = 70000;
  orbit.turns = 2;
  orbit.steps_per_turn = 256;
  orbit.signals.resize(5);
  for (int k = 0; k <= 512; ++k) {
    const double phase = 2 * std::numbers::pi * k / 256;
    orbit.signals[0].push_back(3e-3 * std::cos(phase));
    orbit.signals[1].push_back(1e-3 * std::sin(phase) + 5e-4);
    orbit.signals[2].push_back(0);
    orbit.signals[3].push_back(1e-5 * std::sin(8 * phase));
    orbit.signals[4].push_back(1.4999e-3 - orbit.signals[1].back());
  }
  orbit.section_m = {{3e-3, 5e-4}, {-3e-3, 4e-4}};
  orbit.spectrum = {2, 4, {0, 0, 1e-7, 2e-3, 5e-4, 0, 1e-3, 1e-5}};
  return orbit;
}

TEST(OrbitsEncodeOrbit, IsReadBackWithinItsLevels) {
  const SettledOrbit orbit = ellipse();
  Bytes bytes(encode_orbit(1319, orbit));
  EXPECT_EQ(bytes.integer(4), 1319u);
  bytes.integer(4);
  EXPECT_EQ(bytes.integer(4), 70000u);
  EXPECT_EQ(bytes.integer(2), 2u);
  EXPECT_EQ(bytes.integer(2), 256u);
  const auto samples = bytes.integer(2);
  EXPECT_EQ(bytes.integer(2), 5u);
  EXPECT_LT(samples, 170u);
  std::vector<std::size_t> steps;
  for (const int gap : bytes.planes16(samples))
    steps.push_back((steps.empty() ? 0 : steps.back()) + static_cast<std::size_t>(gap));
  EXPECT_EQ(steps.front(), 0u);
  EXPECT_EQ(steps.back(), 512u);
  for (const std::vector<double>& signal : orbit.signals) {
    const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
    const double level = (*high - *low) / levels;
    const std::vector<double> values = bytes.levels(samples);
    for (std::size_t i = 0; i < samples; ++i) EXPECT_NEAR(values[i], signal[steps[i]], 0.51 * level + 1e-9);
  }
  EXPECT_EQ(bytes.integer(2), 2u);
  const auto x = bytes.levels(2), y = bytes.levels(2);
  EXPECT_NEAR(x[0], 3e-3, 1e-9);
  EXPECT_NEAR(x[1], -3e-3, 1e-9);
  EXPECT_NEAR(y[1], 4e-4, 1e-9);
  // Lines at -1/2, 0, 1 and 3/2; all others are below a thousandth of the largest.
  EXPECT_EQ(bytes.integer(2), 2u);
  EXPECT_EQ(bytes.integer(2), 4u);
  EXPECT_FLOAT_EQ(bytes.number(), 2e-3f);
  const std::vector<int> places{-1, 0, 2, 3};
  for (const int place : places) EXPECT_EQ(static_cast<std::int16_t>(bytes.integer(2)), place);
  for (const double amplitude : {2e-3, 5e-4, 1e-3, 1e-5})
    EXPECT_NEAR(2e-3 * static_cast<double>(bytes.integer(2)) / 65535, amplitude, 2e-8);
  EXPECT_TRUE(bytes.at_end());
}

TEST(OrbitsEncodeOrbit, KeepsBothSidesOfEachChangeOfContact) {
  const SettledOrbit orbit = ellipse();
  Bytes bytes(encode_orbit(0, orbit));
  for (const std::size_t size : {4u, 4u, 4u, 2u, 2u}) bytes.integer(size);
  const auto samples = bytes.integer(2);
  bytes.integer(2);
  std::vector<std::size_t> steps;
  for (const int gap : bytes.planes16(samples))
    steps.push_back((steps.empty() ? 0 : steps.back()) + static_cast<std::size_t>(gap));
  int changes = 0;
  for (std::size_t k = 1; k < orbit.signals[4].size(); ++k) {
    if ((orbit.signals[4][k] < 0) == (orbit.signals[4][k - 1] < 0)) continue;
    ++changes;
    EXPECT_TRUE(std::binary_search(steps.begin(), steps.end(), k));
    EXPECT_TRUE(std::binary_search(steps.begin(), steps.end(), k - 1));
  }
  EXPECT_EQ(changes, 4);
}

TEST(OrbitsEncodeOrbit, ASignalThatRestsHasOneLevel) {
  std::string bytes;
  const std::vector<double> rest(10, 1e-3);
  append_levels(bytes, rest);
  for (const double value : Bytes(bytes).levels(10)) EXPECT_NEAR(value, 1e-3, 1e-10);
}

using Signals = std::vector<std::vector<double>>;

std::vector<double> circle(int steps) {
  std::vector<double> values;
  for (int k = 0; k <= steps; ++k) values.push_back(std::cos(2 * std::numbers::pi * k / steps));
  return values;
}

/// Largest distance of any sample from the straight line between its kept neighbours.
double largest_distance(const std::vector<double>& signal, const std::vector<std::size_t>& kept) {
  double largest = 0;
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const auto next = std::upper_bound(kept.begin(), kept.end(), k);
    if (next == kept.end()) continue;
    const std::size_t a = *(next - 1), b = *next;
    const double slope = (signal[b] - signal[a]) / static_cast<double>(b - a);
    largest = std::max(largest, std::abs(signal[k] - signal[a] - slope * static_cast<double>(k - a)));
  }
  return largest;
}

TEST(OrbitsEncodeOrbit, AStraightLineNeedsItsEnds) {
  const Signals signals{{0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(needed_samples(signals, 1e-12, {}), (std::vector<std::size_t>{0, 5}));
}

TEST(OrbitsEncodeOrbit, ACornerStays) {
  const Signals signals{{0, 0, 0, 1, 2, 3}, {5, 5, 5, 5, 5, 5}};
  EXPECT_EQ(needed_samples(signals, 1e-12, {}), (std::vector<std::size_t>{0, 2, 5}));
}

TEST(OrbitsEncodeOrbit, NoSampleIsMissedByMoreThanTheTolerance) {
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-5}) {
    Signals signals{circle(512), circle(512)};
    for (std::size_t k = 0; k < signals[1].size(); ++k) signals[1][k] = std::abs(signals[1][k]) - 0.3;
    const auto kept = needed_samples(signals, tolerance, {});
    for (const auto& signal : signals) EXPECT_LE(largest_distance(signal, kept), tolerance);
  }
}

TEST(OrbitsEncodeOrbit, ACircleTakesAboutAsManyAsItsSagittaSays) {
  // Chords of a cosine with an error of at most e: arcs of about sqrt(8 e) where the curvature is largest.
  const Signals signals{circle(512)};
  const auto kept = needed_samples(signals, 2.5e-3, {});
  EXPECT_GT(kept.size(), 20u);
  EXPECT_LT(kept.size(), 60u);
}

TEST(OrbitsEncodeOrbit, AskedOnesStayAndAllAscend) {
  const Signals signals{{0, 1, 2, 3, 4, 5}};
  const std::vector<std::size_t> always{0, 2, 3, 5};
  EXPECT_EQ(needed_samples(signals, 1e-12, always), always);
}

TEST(Orbits, ASmallMapKeepsAllItsCells) {
  const ThinnedGrid grid = thinned_grid(3, 2, 6);
  EXPECT_TRUE(grid.whole());
  EXPECT_EQ(grid.cells(), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Orbits, ALargeOneKeepsSomeAllOverIt) {
  const ThinnedGrid grid = thinned_grid(400, 250, 4000);
  EXPECT_FALSE(grid.whole());
  const auto cells = grid.cells();
  EXPECT_LE(cells.size(), 4000u);
  EXPECT_GT(cells.size(), 2500u);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  EXPECT_LT(cells.back(), 100000u);
  // The distance from every cell to a kept one is at most half a stride.
  EXPECT_LT(cells.front() % 400, grid.speed_stride);
  EXPECT_GE(cells.back() % 400 + grid.speed_stride, 400u);
}

TEST(Orbits, ALineKeepsItsOtherAxis) {
  const ThinnedGrid grid = thinned_grid(1000, 1, 10);
  EXPECT_EQ(grid.unbalance_stride, 1u);
  EXPECT_LE(grid.cells().size(), 10u);
  EXPECT_GE(grid.cells().size(), 9u);
  EXPECT_EQ(thinned_grid(1, 1000, 1).cells().size(), 1u);
  EXPECT_EQ(thinned_grid(100, 1000, 1).cells().size(), 1u);
}

/// A study over clearances, one of which is not allowed.
sweep::Study clearance_study(std::vector<double> clearance_m) {
  sweep::Study study = sweep::one_side_study({50, 60}, {0.2});
  study.grid.axes = {{{"stops.0.clearance_m"}, {1}, std::move(clearance_m)}};
  study.with_keys = [machine = study.machine](std::span<const sweep::KeyValue> keys) {
    if (!(keys.front().value > 0)) throw ConfigError("stops.0.clearance_m: allowed: a number > 0");
    sweep::Study own;
    own.machine = machine;
    own.machine.stops.front().clearance_m = keys.front().value;
    return own;
  };
  return study;
}

TEST(OrbitsWalls, AreThoseOfTheMachineWithoutAxesOverKeys) {
  const sweep::Study study = sweep::one_side_study({50, 60, 70}, {0.2, 0.6});
  const Walls walls = walls_of(study);
  ASSERT_EQ(walls.lists.size(), 1u);
  EXPECT_EQ(walls.list_of_keys, std::vector<std::size_t>{0});
  ASSERT_EQ(walls.lists.front().size(), study.machine.stops.size());
  EXPECT_DOUBLE_EQ(walls.lists.front().front().clearance_m, study.machine.stops.front().clearance_m);
  EXPECT_FALSE(walls.lists.front().front().around);
}

TEST(OrbitsWalls, AreToldOnceForEachPlaceThatKeysPutThem) {
  const Walls walls = walls_of(clearance_study({1e-4, 2e-4, 1e-4}));
  EXPECT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1, 0}));
  ASSERT_EQ(walls.lists.size(), 2u);
  EXPECT_DOUBLE_EQ(walls.lists[0].front().clearance_m, 1e-4);
  EXPECT_DOUBLE_EQ(walls.lists[1].front().clearance_m, 2e-4);
}

TEST(OrbitsWalls, AreNoneWhereKeysAreNotAllowed) {
  const Walls walls = walls_of(clearance_study({-1, 1e-4}));
  ASSERT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(walls.lists[0].empty());
  EXPECT_FALSE(walls.lists[1].empty());
}

}  // namespace

}  // namespace rubsweep::page
