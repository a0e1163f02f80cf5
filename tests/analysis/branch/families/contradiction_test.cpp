#include "rubsweep/analysis/branch/families/contradiction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "analysis/branch/families/half_orbit_study.hpp"
#include "rubsweep/analysis/branch/continuation/branch_point.hpp"

namespace rubsweep::branch::families {
namespace {

sweep::Study study_of_one_ratio() { return test::half_orbit_study({0.4}); }

/// The half orbit at a whirl ratio of 0.4, which exists from 61.6 to 90.9 Hz: cells 1 to 3, where the kick of
/// cell 2 leads to it.
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

/// The half orbit in two: the first family ends before cell 3 in `end`, the second one has that cell.
Families parted(std::string_view end) {
  const Family& whole = half_orbit().list.at(0);
  Family first{2, {{2, whole.orbits.at(2)}}, {{2, 3, 80, 0.4, end}}, {2}};
  Family second{3, {{3, whole.orbits.at(3)}}, {}, {3}};
  return {{first, second}, {}};
}

TEST(Contradictions, TheMachineStaysWhereItsOrbitIsStable) {
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

/// A state on no orbit of the machine is left at once: here the state at rest in the quiet motion's stead.
TEST(Contradictions, TheMachineLeavesWhatIsNoOrbit) {
  Families families = half_orbit();
  families.list[0].orbits.at(1).state.setZero();
  const auto found = check(families, labels());
  ASSERT_EQ(found[0].cell, 1u);
  EXPECT_EQ(found[0].finding, CheckResult::leaves);
  EXPECT_TRUE(contradicts(found[0].finding));
}

TEST(Contradictions, ALabelOutsideWithoutAnOrbit) {
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
  // A label of another kind is none to look at.
  with_outside[4] = "subharmonic_3";
  EXPECT_EQ(check(half_orbit(), with_outside).size(), 3u);
}

TEST(Contradictions, OrbitsSideBySide) {
  Families families = parted("fold");
  families.list[1].ends = {{3, 2, 78, 0.4, "period_doubling"}};
  EXPECT_EQ(finding_outside(families), CheckResult::ends_as_well);
  families.list[1].ends[0].kind = "point_limit";
  EXPECT_EQ(finding_outside(families), CheckResult::not_followed);
  families = parted("step_too_small");
  EXPECT_EQ(finding_outside(families), CheckResult::not_followed);
}

/// The second family's orbit goes on into cell 2. There it must be another one: the same means that the end
/// of the first one is none.
TEST(Contradictions, OneOrbitInTwoFamilies) {
  Families families = parted("fold");
  families.list[1].orbits.emplace(2, families.list[0].orbits.at(2));
  EXPECT_EQ(finding_outside(families), CheckResult::same_orbit);
  families.list[1].orbits.at(2).state *= 1.01;
  EXPECT_EQ(finding_outside(families), CheckResult::another_orbit);
}

TEST(Contradictions, GoOnFromWhatWasFound) {
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
