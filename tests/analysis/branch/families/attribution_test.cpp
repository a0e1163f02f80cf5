#include "rubsweep/analysis/branch/families/attribution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/branch/families/half_orbit_study.hpp"
#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/core/structure/stability.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::branch::families {
namespace {

/// The quiet whirl of a Jeffcott rotor of 30 Hz reaches the wall only near its resonance.
TEST(AttributionQuietCells, TouchNearResonance) {
  sweep::Study study;
  study.machine = test::machine_of({});
  study.grid.measure = sweep::UnbalanceMeasure::eccentricity_m;
  study.grid.speed_hz = {10, 30, 90};
  study.grid.unbalance = {1e-6, 2e-4};
  using enum Quiet;
  EXPECT_EQ(quiet_cells(study), (std::vector<Quiet>{stable, stable, stable, stable, touches, stable}));
}

/// Rotating damping makes the free rotor unstable above a speed.
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

/// A grid of cells at 10, 20, ... Hz.
sweep::Grid row_of(std::size_t cells) {
  sweep::Grid grid;
  for (std::size_t i = 1; i <= cells; ++i) grid.speed_hz.push_back(10.0 * static_cast<double>(i));
  grid.unbalance = {0.5};
  return grid;
}

std::vector<Quiet> no_quiet_motion(std::size_t cells) { return std::vector<Quiet>(cells, Quiet::touches); }

/// Five cells in a row. The first two belong to family 0, whose orbit continues into the third cell and ends
/// in a fold before the fourth. The orbit of the last cell could not be followed.
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

/// Cells A and B are neighbours. The orbit of A continues into B, but the orbit of B does not continue into
/// A: the edge is named after the orbit that ends.
TEST(Attribution, WhatCeasesOnOneSideIsStronger) {
  const sweep::Grid grid = row_of(2);
  const std::array<std::string, 2> labels{"subharmonic_2", "subharmonic_4"};
  const Family a{0, {{0, {}}, {1, {}}}, {}, {0}}, b{1, {{1, {}}}, {{1, 0, 15, 0.5, "period_halving"}}, {1}};
  const auto edges = attribute(grid, labels, {a, b}, no_quiet_motion(2), at_rest);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].attribution, Attribution::ceases);
  EXPECT_EQ(edges[0].kind, "period_halving");
}

/// The quiet motion is treated like a followed orbit. Next to chaos the quiet motion exists on both sides;
/// where its whirl would touch or grow, it ceases. If the other motion ceases, the edge is named after that.
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

sweep::Study study_of_one_ratio() { return test::half_orbit_study({0.4}); }

/// The half orbit at a whirl ratio of 0.4, which exists from 61.6 to 90.9 Hz: cells 1 to 3. The kick leads to
/// it in cell 2.
const Families& half_orbit() {
  static const Families families = [] {
    const std::atomic<bool> stop{false};
    const std::vector<std::size_t> proven{2};
    return families_of(study_of_one_ratio(), proven, 1, stop);
  }();
  return families;
}

std::vector<std::string> labels() {
  return {"non_contact", "non_contact", "subharmonic_2", "chaotic", "non_contact"};
}

std::vector<LabelCheck> check(const Families& families, const std::vector<std::string>& labels,
                              FamilyRecords records = {}, int threads = 1) {
  const std::atomic<bool> stop{false};
  return check_labels(study_of_one_ratio(), labels, families, threads, stop, records);
}

CheckResult finding_outside(const Families& families) {
  std::vector<std::string> with_outside = labels();
  with_outside[3] = "subharmonic_2";
  for (const LabelCheck& found : check(families, with_outside)) {
    if (!found.inside) return found.finding;
  }
  ADD_FAILURE() << "nothing was looked at outside";
  return CheckResult::reached;
}

/// The half orbit divided into two families. The first family ends before cell 3 with the event `end`; cell 3
/// belongs to the second family.
Families parted(std::string_view end) {
  const Family& whole = half_orbit().list.at(0);
  Family first{2, {{2, whole.orbits.at(2)}}, {{2, 3, 80, 0.4, end}}, {2}};
  Family second{3, {{3, whole.orbits.at(3)}}, {}, {3}};
  return {{first, second}, {}};
}

TEST(AttributionContradictions, TheMachineStaysWhereItsOrbitIsStable) {
  for (const int threads : {1, 2}) {
    const auto found = check(half_orbit(), labels(), {}, threads);
    ASSERT_EQ(found.size(), 3u);
    for (const LabelCheck& one : found) {
      EXPECT_TRUE(one.inside);
      EXPECT_EQ(one.family, 0u);
      EXPECT_EQ(one.finding, one.cell == 2 ? CheckResult::reached : CheckResult::stays) << one.cell;
    }
  }
}

/// A machine that starts from a state on no orbit leaves this state. Here the state is the rest state instead
/// of the quiet motion.
TEST(AttributionContradictions, TheMachineLeavesWhatIsNoOrbit) {
  Families families = half_orbit();
  families.list[0].orbits.at(1).state.setZero();
  const auto found = check(families, labels());
  ASSERT_EQ(found[0].cell, 1u);
  EXPECT_EQ(found[0].finding, CheckResult::leaves);
  EXPECT_TRUE(contradicts(found[0].finding));
}

TEST(AttributionContradictions, ALabelOutsideWithoutAnOrbit) {
  std::vector<std::string> with_outside = labels();
  with_outside[4] = "subharmonic_2";
  Families families = half_orbit();
  auto found = check(families, with_outside);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_FALSE(found[3].inside);
  EXPECT_EQ(found[3].finding, CheckResult::unproven);
  EXPECT_EQ(found[3].end, "fold");
  families.not_followed = {4};
  found = check(families, with_outside);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found[3].finding, CheckResult::not_found);
  EXPECT_EQ(found[4].finding, CheckResult::not_found);
  EXPECT_EQ(found[4].family, std::nullopt);
  // A label of another kind than that of the family is not examined.
  with_outside[4] = "subharmonic_3";
  EXPECT_EQ(check(half_orbit(), with_outside).size(), 3u);
}

TEST(AttributionContradictions, OrbitsSideBySide) {
  Families families = parted("fold");
  families.list[1].ends = {{3, 2, 78, 0.4, "period_doubling"}};
  EXPECT_EQ(finding_outside(families), CheckResult::ends_as_well);
  families.list[1].ends[0].kind = "point_limit";
  EXPECT_EQ(finding_outside(families), CheckResult::not_followed);
  families = parted("step_too_small");
  EXPECT_EQ(finding_outside(families), CheckResult::not_followed);
}

/// The second family's orbit continues into cell 2. If it is the same orbit there, the end of the first
/// family is wrong.
TEST(AttributionContradictions, OneOrbitInTwoFamilies) {
  Families families = parted("fold");
  families.list[1].orbits.emplace(2, families.list[0].orbits.at(2));
  EXPECT_EQ(finding_outside(families), CheckResult::same_orbit);
  families.list[1].orbits.at(2).state *= 1.01;
  EXPECT_EQ(finding_outside(families), CheckResult::another_orbit);
}

TEST(AttributionContradictions, GoOnFromWhatWasFound) {
  FamilyRecords known;
  ASSERT_TRUE(known.read(2, "stays 1 0"));
  ASSERT_TRUE(known.read(2, "stays 3 1"));
  const auto found = check(half_orbit(), labels(), known);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].finding, CheckResult::leaves) << "as the records say";
  EXPECT_EQ(found[2].finding, CheckResult::stays);
}

}  // namespace

}  // namespace rubsweep::branch::families
