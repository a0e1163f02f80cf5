#include "keys/key_list.hpp"

#include <gtest/gtest.h>

#include <set>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

using namespace config::keys;

namespace {

TEST(KeyList, EveryKeyHasAMeaningAndIsThereOnce) {
  std::set<std::string> paths;
  for (const KeyRow& row : key_list(config::run_form())) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_GE(row.meaning.size(), 3u) << row.path;
    EXPECT_FALSE(row.allowed.empty()) << row.path;
    EXPECT_TRUE(row.since == "0.1.0" || row.since == "0.2.0") << row.path;
  }
  EXPECT_GE(paths.size(), 300u);
}

TEST(KeyList, NumbersOfAPathAreThoseOfAnyItem) {
  const auto rows = key_list(config::run_form());
  const auto friction = below(rows, "stops.0.friction");
  ASSERT_FALSE(friction.empty());
  EXPECT_EQ(friction.front().path, "stops.N.friction");
  EXPECT_EQ(friction.size(), below(rows, "stops.N.friction").size());
  EXPECT_EQ(below(rows, "stops.12.friction.coefficient").size(), 1u);
  EXPECT_TRUE(below(rows, "stops.0.fric").empty());
  EXPECT_EQ(below(rows, "").size(), rows.size());
}

TEST(KeyList, WordsOfAlternativesComeTogether) {
  const auto kinds = below(key_list(config::run_form()), "rotor.kind");
  ASSERT_EQ(kinds.size(), 1u);
  EXPECT_EQ(kinds[0].allowed, "jeffcott or rotor_kit or ross or matrices");
}

TEST(KeyList, AlternativesOfAMapNameTheirKind) {
  const auto rows = key_list(config::run_form());
  EXPECT_EQ(below(rows, "rotor.damping_ratio")[0].allowed,
            ">= 0 with kind: jeffcott, otherwise >= 0 and <= 1, or a list of 1 to 400 such numbers");
  EXPECT_EQ(below(rows, "rotor.unbalance")[0].allowed,
            "list of 1 to 400 maps with kind: ross, otherwise a map, or a list of 1 to 2000 maps");
}

TEST(KeyList, KeysThatExcludeEachOtherSaySo) {
  EXPECT_EQ(below(key_list(config::run_form()), "stops.0.restitution")[0].fallback, "one of several");
  EXPECT_EQ(below(key_list(config::run_form()), "stops.0.clearance_m")[0].fallback, "required");
}

TEST(KeyList, TextNamesUnitRangeAndDefault) {
  EXPECT_EQ(text_of(below(key_list(config::run_form()), "rotor.mass_kg")),
            "rotor.mass_kg\n    mass of the disc: the modal mass there\n    > 0; in kg; required\n");
  EXPECT_EQ(text_of(below(key_list(config::run_form()), "response.hertz_iterations")),
            "response.hertz_iterations\n    how often a cell whose force leaves the range of a hertz "
            "stiffness is run "
            "again\n    integer, 0 to 20; default 0; since 0.2.0\n");
}

}  // namespace
}  // namespace rubsweep::apps
