#include "rubsweep/analysis/branch/families/family.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "analysis/branch/families/half_orbit_study.hpp"
#include "core/response/annular_cell.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::branch::families {
namespace {

/// Families without records of an earlier run.
Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop) {
  FamilyRecords records;
  return families_of(study, proven, threads, stop, records);
}

sweep::Study study_of_two_ratios() { return test::half_orbit_study({0.3, 0.4}); }

/// The 1/2 orbit of parameter set A at a whirl ratio of 0.4 exists from 61.6455 to 90.9129 Hz. The family
/// has the cells in between and ends at these folds, which continuation of the whole branch finds as well.
TEST(FamilyFamilies, TheHalfOrbitOfAMap) {
  const std::atomic<bool> stop{false};
  const std::vector<std::size_t> proven{7};  // 75 Hz, 0.4
  const Families families = families_of(study_of_two_ratios(), proven, 2, stop);
  EXPECT_TRUE(families.not_followed.empty());
  ASSERT_EQ(families.list.size(), 1u);
  const Family& family = families.list[0];
  EXPECT_EQ(family.order(), 2);
  EXPECT_EQ(family.reached, proven);
  ASSERT_TRUE(family.orbits.contains(6) && family.orbits.contains(8));
  const FamilyEnd *low = family.end_between(6, 5), *high = family.end_between(8, 9);
  ASSERT_TRUE(low && high);
  EXPECT_EQ(low->kind, "fold");
  EXPECT_EQ(high->kind, "fold");

  response::motion::Workspace workspace;
  orbits::OrbitProblem problem = orbits::scene_orbits(
      [](double speed_hz) -> std::optional<scene::Scene> {
        return test::cell_of({.speed_hz = speed_hz, .whirl_ratio = 0.4}).scene;
      },
      2, {}, workspace.modes);
  problem.low = 45;
  problem.high = 240;
  problem.parameter_scale = 195;
  const auto start = continuation::orbit_from(problem, family.orbits.at(7).state, 75);
  ASSERT_TRUE(start);
  const continuation::Branch branch = continuation::follow_both_ways(problem, *start, {});
  ASSERT_EQ(branch.events.size(), 2u);
  EXPECT_NEAR(std::max(branch.events[0].point.parameter, branch.events[1].point.parameter), high->speed_hz,
              1e-8);
  EXPECT_NEAR(std::min(branch.events[0].point.parameter, branch.events[1].point.parameter), low->speed_hz,
              1e-8);
}

TEST(FamilyFamilies, DoNotDependOnTheNumberOfThreads) {
  const std::atomic<bool> stop{false};
  const std::vector<std::size_t> proven{2, 3, 7};
  const Families one = families_of(study_of_two_ratios(), proven, 1, stop),
                 three = families_of(study_of_two_ratios(), proven, 3, stop);
  ASSERT_EQ(one.list.size(), three.list.size());
  for (std::size_t i = 0; i < one.list.size(); ++i) {
    const Family &a = one.list[i], &b = three.list[i];
    EXPECT_EQ(a.reached, b.reached);
    ASSERT_EQ(a.orbits.size(), b.orbits.size());
    for (const auto& [cell, orbit] : a.orbits) EXPECT_EQ(orbit.state, b.orbits.at(cell).state);
    ASSERT_EQ(a.ends.size(), b.ends.size());
    for (std::size_t k = 0; k < a.ends.size(); ++k) {
      EXPECT_EQ(a.ends[k].speed_hz, b.ends[k].speed_hz);
      EXPECT_EQ(a.ends[k].kind, b.ends[k].kind);
    }
  }
}

/// Families that were stopped after any number of records continue to the same result.
TEST(FamilyFamilies, GoOnFromWhatWasFound) {
  const std::vector<std::size_t> proven{2, 3, 7};
  std::atomic<bool> stop{false};
  std::vector<std::pair<std::size_t, std::string>> lines;
  FamilyRecords whole([&](std::size_t cell, std::string_view line) { lines.emplace_back(cell, line); });
  const Families undisturbed = families_of(study_of_two_ratios(), proven, 2, stop, whole);
  ASSERT_GT(lines.size(), 6u);

  std::size_t kept = 0;
  FamilyRecords first([&](std::size_t, std::string_view) { stop = ++kept == lines.size() / 2; });
  families_of(study_of_two_ratios(), proven, 1, stop, first);
  EXPECT_LT(kept, lines.size());
  stop = false;
  const Families resumed = families_of(study_of_two_ratios(), proven, 1, stop, first);
  EXPECT_EQ(kept, lines.size()) << "nothing is found twice";
  ASSERT_EQ(resumed.list.size(), undisturbed.list.size());
  for (std::size_t i = 0; i < resumed.list.size(); ++i) {
    EXPECT_EQ(resumed.list[i].reached, undisturbed.list[i].reached);
    ASSERT_EQ(resumed.list[i].orbits.size(), undisturbed.list[i].orbits.size());
    for (const auto& [cell, orbit] : resumed.list[i].orbits)
      EXPECT_EQ(orbit.state, undisturbed.list[i].orbits.at(cell).state);
  }
}

/// Full annular rub in closed form, with casing and friction. With the dynamic stiffness R of the rotor and C
/// of the casing, and F = K (|u| - c) (1 + i mu) u / |u| at the approach u = z - z_c, the circle satisfies R
/// (u + F / C) + F = m e w^2. |left side|^2 is a quadratic in |u|; its minimum gives the smallest unbalance
/// of the circle, a fold. The result is the whirl ratio, the radius of the quiet circle / c.
double least_whirl_ratio_of_a_circle(double speed_hz) {
  constexpr double mass = 0.8, natural = 2 * std::numbers::pi * 30, damping_ratio = 0.04;
  constexpr double casing_mass = 0.05, casing_stiffness = 5e5, contact = 2e6, mu = 0.02, clearance = 1e-3;
  const double w = 2 * std::numbers::pi * speed_hz;
  const auto dynamic = [w](double m, double k, double ratio) {
    return std::complex<double>(k - m * w * w, 2 * ratio * std::sqrt(k * m) * w);
  };
  const std::complex<double> rotor = dynamic(mass, mass * natural * natural, damping_ratio),
                             casing = dynamic(casing_mass, casing_stiffness, 1),
                             press = contact * std::complex<double>(1, mu) * (rotor / casing + 1.0);
  const std::complex<double> a = rotor + press, b = -press * clearance;
  const double approach = -(std::conj(a) * b).real() / std::norm(a);
  EXPECT_GT(approach, clearance) << "it touches";
  return std::abs(a * approach + b) / (clearance * std::abs(rotor));
}

/// Circles and ovals in an annulus: two families in one map. The circle ends at the fold of its closed form,
/// on both axes.
TEST(FamilyFamilies, CirclesAndOvalsInAnAnnulus) {
  sweep::Study annulus;
  annulus.machine = response::testing::annular_machine();
  annulus.grid.speed_hz = {60, 80, 165, 170};
  annulus.grid.unbalance = {0.2, 0.6};
  const std::atomic<bool> stop{false};
  const std::vector<std::size_t> proven{5, 6};  // the cells at a whirl ratio of 0.6
  const Families families = families_of(annulus, proven, 2, stop);
  EXPECT_TRUE(families.not_followed.empty());
  ASSERT_EQ(families.list.size(), 2u);
  const Family &circle = families.list[0], &oval = families.list[1];
  EXPECT_EQ(circle.closing(), orbits::Closing::with_the_shaft);
  EXPECT_EQ(oval.closing(), orbits::Closing::in_the_turning_frame);
  EXPECT_EQ(oval.reached, std::vector<std::size_t>{6});
  EXPECT_TRUE(oval.orbits.contains(7)) << "the neighbour's oval";
  EXPECT_EQ(oval.orbits.at(7).state.size(), 9);

  int folds = 0;
  for (const FamilyEnd& end : circle.ends) {
    if (end.kind != "fold") continue;
    ++folds;
    EXPECT_NEAR(least_whirl_ratio_of_a_circle(end.speed_hz), end.unbalance, 1e-9) << end.speed_hz;
  }
  EXPECT_GE(folds, 3) << "two along the speed, one along the unbalance";
}

/// A cell whose kick leads to rest has no orbit to follow, whatever the map shows.
TEST(FamilyFamilies, ACellThatIsNotFound) {
  const std::atomic<bool> stop{false};
  sweep::Study at_rest = study_of_two_ratios();
  at_rest.machine.kick->force_n = 1;
  const std::vector<std::size_t> proven{7};
  const Families families = families_of(at_rest, proven, 1, stop);
  EXPECT_TRUE(families.list.empty());
  EXPECT_EQ(families.not_followed, proven);
}

sweep::Grid grid() {
  sweep::Grid grid;
  grid.speed_hz = {10, 20, 30, 40};
  grid.unbalance = {0.1, 0.2, 0.3};
  return grid;
}

/// A family in these cells, which ends halfway to all other cells: to the right by a fold, elsewhere by a
/// doubling.
Family family_in(const std::vector<std::size_t>& cells) {
  Family family;
  family.seed = cells.front();
  for (const std::size_t cell : cells) family.orbits[cell] = {};
  for (const std::size_t cell : cells) {
    for (const std::size_t next : neighbours_of(grid(), cell)) {
      if (family.orbits.contains(next)) continue;
      const auto at = [](std::size_t i) {
        return std::pair(grid().speed_hz[i % 4], grid().unbalance[i / 4]);
      };
      const auto [x1, y1] = at(cell);
      const auto [x2, y2] = at(next);
      family.ends.push_back(
          {cell, next, (x1 + x2) / 2, (y1 + y2) / 2, next == cell + 1 ? "fold" : "doubling"});
    }
  }
  return family;
}

TEST(FamilyOutlineNeighbours, AtCornersAndInside) {
  EXPECT_EQ(neighbours_of(grid(), 0), (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(neighbours_of(grid(), 5), (std::vector<std::size_t>{4, 6, 1, 9}));
  EXPECT_EQ(neighbours_of(grid(), 11), (std::vector<std::size_t>{10, 7}));
}

/// The outline is closed around one inner cell, and divided where the kind of boundary changes.
TEST(FamilyOutline, AroundOneCell) {
  const auto lines = outline_of(grid(), family_in({5}));
  for (const OutlineLine& line : lines) EXPECT_TRUE(line.kind == "fold" || line.kind == "doubling");
  ASSERT_EQ(lines.size(), 3u);  // below; right; above, left and again below
  EXPECT_EQ(lines[1].kind, "fold");
  EXPECT_EQ(lines[1].points.back(), (std::array{25.0, 0.2}));
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    EXPECT_EQ(lines[i].points.back(), lines[i + 1].points.front());
  EXPECT_EQ(lines.front().points.front(), lines.back().points.back());
}

/// At the edge of the map a family has no boundary, so the outline is one open line.
TEST(FamilyOutline, EndsWhereTheMapDoes) {
  const auto lines = outline_of(grid(), family_in({0, 1, 4, 5, 8, 9}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].kind, "fold");
  EXPECT_EQ(lines[0].points, (std::vector<std::array<double, 2>>{{25, 0.1}, {25, 0.2}, {25, 0.3}}));
}

TEST(FamilyOutline, NoneAroundTheWholeMap) {
  EXPECT_TRUE(outline_of(grid(), family_in({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})).empty());
}

/// Two cells that touch only in a corner: no end of the family is missing in the outline.
TEST(FamilyOutline, CellsThatMeetInACorner) {
  const Family family = family_in({0, 5});
  std::size_t ends = 0;
  for (const OutlineLine& line : outline_of(grid(), family)) {
    ASSERT_GE(line.points.size(), 1u);
    ends += line.points.size();
  }
  EXPECT_GE(ends, family.ends.size());
}

}  // namespace

}  // namespace rubsweep::branch::families
