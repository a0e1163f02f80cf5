#include "rubsweep/analysis/branch/families/family_records.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"

namespace rubsweep::branch::families {
namespace {

/// An orbit with numbers that differ from others in the last bit only, or that have no short decimal form.
CellOrbit orbit() {
  CellOrbit orbit{6, 17, Eigen::VectorXd(4), orbits::Closing::with_the_shaft};
  orbit.state << 0.1 + 0.2, -0.0, 1.0 / 3, std::numeric_limits<double>::denorm_min();
  return orbit;
}

CellOrbit oval() { return {1, 3, orbit().state, orbits::Closing::in_the_turning_frame}; }

void expect_same(const CellOrbit& a, const CellOrbit& b) {
  EXPECT_EQ(a.order, b.order);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.closing, b.closing);
  EXPECT_EQ(a.state, b.state);
}

TEST(FamilyRecords, ComeBackToTheLastBit) {
  std::vector<std::pair<std::size_t, std::string>> lines;
  FamilyRecords records([&](std::size_t cell, std::string_view line) { lines.emplace_back(cell, line); });
  records.keep_settled(7, orbit());
  records.keep_settled(8, std::nullopt);
  records.keep_settled(9, oval());
  records.keep_passage(7, 7, 8, {orbit(), {}, 75.1});
  records.keep_passage(7, 8, 9, {{}, to_string(continuation::EventKind::period_doubling), 1.0 / 7});
  records.keep_passage(7, 8, 5, {{}, to_string(continuation::Ending::step_too_small), -3});
  ASSERT_EQ(lines.size(), 6u);

  FamilyRecords again;
  for (const auto& [cell, line] : lines) EXPECT_TRUE(again.read(cell, line)) << line;
  ASSERT_TRUE(again.settled(7) && again.settled(7)->has_value());
  expect_same(**again.settled(7), orbit());
  ASSERT_TRUE(again.settled(8));
  EXPECT_FALSE(again.settled(8)->has_value());
  ASSERT_TRUE(again.settled(9) && again.settled(9)->has_value());
  expect_same(**again.settled(9), oval());
  EXPECT_EQ(again.settled(10), nullptr);
  const Passage* there = again.passage(7, 7, 8);
  ASSERT_TRUE(there && there->arrived);
  expect_same(*there->arrived, orbit());
  EXPECT_EQ(there->parameter, 75.1);
  const Passage* cut = again.passage(7, 8, 9);
  ASSERT_TRUE(cut && !cut->arrived);
  EXPECT_EQ(cut->kind, "period_doubling");
  EXPECT_EQ(cut->parameter, 1.0 / 7);
  ASSERT_TRUE(again.passage(7, 8, 5));
  EXPECT_EQ(again.passage(7, 8, 5)->kind, "step_too_small");
  EXPECT_EQ(again.passage(8, 8, 9), nullptr);
  EXPECT_EQ(again.passage(7, 9, 8), nullptr);
}

TEST(FamilyRecords, TakeNothingElse) {
  FamilyRecords records;
  for (const char* line :
       {"", "rest", "settled 2", "settled 2 1 0.5", "settled with_the_shaft 0 1 0.5",
        "settled with_the_shaft 2 1 0.5x", "settled with_the_shaft 2 1  0.5", "settled by_chance 2 1 0.5",
        "way", "way 1 2", "way 1 2 fold", "way 1 2 wall 0.5", "way 1 x fold 0.5", "way 1 2 arrives 0.5",
        "way 1 2 arrives 0.5 with_the_shaft 2 1"})
    EXPECT_FALSE(records.read(1, line)) << line;
  EXPECT_EQ(records.settled(1), nullptr);
  EXPECT_EQ(records.passage(1, 1, 2), nullptr);
}

}  // namespace
}  // namespace rubsweep::branch::families
