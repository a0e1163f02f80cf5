#include "rubsweep/analysis/branch/families/attribution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rubsweep/core/structure/stability.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::branch::families {
namespace {

/// The quiet whirl of a Jeffcott rotor of 30 Hz reaches the wall near its resonance alone.
TEST(AttributionQuietCells, TouchNearResonance) {
  sweep::Study study;
  study.machine = test::machine_of({});
  study.grid.measure = sweep::UnbalanceMeasure::eccentricity_m;
  study.grid.speed_hz = {10, 30, 90};
  study.grid.unbalance = {1e-6, 2e-4};
  using enum Quiet;
  EXPECT_EQ(quiet_cells(study), (std::vector<Quiet>{stable, stable, stable, stable, touches, stable}));
}

/// Damping that turns with the shaft makes the free rotor unstable above a speed.
TEST(AttributionQuietCells, AreUnstableAboveASpeed) {
  sweep::Study study;
  study.machine = test::machine_of({});
  std::get<model::JeffcottRotor>(study.machine.rotor).rotating_damping_ratio = 0.02;
  const auto prepared = scene::prepare_machine(study.machine);
  const auto from_hz = structure::instability_hz(prepared.assembly, 200);
  ASSERT_TRUE(from_hz);
  study.grid.speed_hz = {0.99 * *from_hz, 1.01 * *from_hz};
  study.grid.unbalance = {0.1};
  EXPECT_EQ(quiet_cells(study), (std::vector<Quiet>{Quiet::stable, Quiet::unstable}));
}

constexpr std::string_view at_rest = "non_contact";

/// Cells at 10, 20, ... Hz.
sweep::Grid row_of(std::size_t cells) {
  sweep::Grid grid;
  for (std::size_t i = 1; i <= cells; ++i) grid.speed_hz.push_back(10.0 * static_cast<double>(i));
  grid.unbalance = {0.5};
  return grid;
}

std::vector<Quiet> no_quiet_motion(std::size_t cells) { return std::vector<Quiet>(cells, Quiet::touches); }

/// Five cells in a row: two of family 0, whose orbit goes on to the third and folds before the fourth; the
/// last one has an orbit that could not be followed.
TEST(Attribution, BasinCeasesAndUnresolved) {
  const sweep::Grid grid = row_of(5);
  const std::array<std::string, 5> labels{"subharmonic_2", "subharmonic_2", "non_contact", "chaotic",
                                          "subharmonic_3"};
  Family first{0, {{0, {}}, {1, {}}, {2, {}}}, {{2, 3, 35, 0.5, "fold"}}, {0, 1}};
  Family last{4, {{4, {}}}, {{4, 3, 45, 0.5, "step_too_small"}}, {4}};
  const auto edges = attribute(grid, labels, {first, last}, no_quiet_motion(5), at_rest);
  ASSERT_EQ(edges.size(), 3u);
  EXPECT_EQ(edges[0].attribution, Attribution::basin);
  EXPECT_EQ(edges[0].first, 1u);
  EXPECT_EQ(edges[1].attribution, Attribution::unresolved);
  EXPECT_EQ(edges[2].attribution, Attribution::unresolved);
  EXPECT_EQ(edges[2].kind, "step_too_small");

  first.orbits.erase(2);
  first.ends = {{1, 2, 25, 0.5, "fold"}};
  const auto ceases = attribute(grid, labels, {first, last}, no_quiet_motion(5), at_rest);
  EXPECT_EQ(ceases[0].attribution, Attribution::ceases);
  EXPECT_EQ(ceases[0].kind, "fold");
}

/// One of two orbits side by side goes on into the other's cell: what the map shows there ceases all the
/// same.
TEST(Attribution, WhatCeasesOnOneSideIsStronger) {
  const sweep::Grid grid = row_of(2);
  const std::array<std::string, 2> labels{"subharmonic_2", "subharmonic_4"};
  const Family a{0, {{0, {}}, {1, {}}}, {}, {0}}, b{1, {{1, {}}}, {{1, 0, 15, 0.5, "period_halving"}}, {1}};
  const auto edges = attribute(grid, labels, {a, b}, no_quiet_motion(2), at_rest);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].attribution, Attribution::ceases);
  EXPECT_EQ(edges[0].kind, "period_halving");
}

/// The quiet motion is one that could be followed as well: beside chaos it is there on both sides, where its
/// whirl would touch or grow it ceases, and what ceases of the other motion is stronger.
TEST(Attribution, TheQuietMotion) {
  const sweep::Grid grid = row_of(5);
  const std::array<std::string, 5> labels{"chaotic", "non_contact", "subharmonic_2", "non_contact",
                                          "unsettled"};
  std::vector<Quiet> quiet(5, Quiet::stable);
  Family family{2, {{1, {}}, {2, {}}}, {{2, 3, 35, 0.5, "fold"}}, {2}};
  auto edges = attribute(grid, labels, {family}, quiet, at_rest);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_EQ(edges[0].attribution, Attribution::basin);
  EXPECT_EQ(edges[0].kind, one_motion);
  EXPECT_EQ(edges[1].attribution, Attribution::basin);
  EXPECT_EQ(edges[1].kind, "") << "both are there on both sides";
  EXPECT_EQ(edges[2].attribution, Attribution::ceases);
  EXPECT_EQ(edges[2].kind, "fold");
  EXPECT_EQ(edges[3].kind, one_motion);
  quiet[0] = Quiet::touches;
  quiet[4] = Quiet::unstable;
  edges = attribute(grid, labels, {family}, quiet, at_rest);
  EXPECT_EQ(edges[0].attribution, Attribution::ceases);
  EXPECT_EQ(edges[0].kind, "graze");
  EXPECT_EQ(edges[3].attribution, Attribution::ceases);
  EXPECT_EQ(edges[3].kind, "stability");
}

TEST(Attribution, KindsThatAreNoEnds) {
  EXPECT_TRUE(is_an_end("fold"));
  EXPECT_TRUE(is_an_end("graze"));
  EXPECT_TRUE(is_an_end("infeasible"));
  EXPECT_FALSE(is_an_end("point_limit"));
  EXPECT_FALSE(is_an_end("step_too_small"));
}

}  // namespace
}  // namespace rubsweep::branch::families
