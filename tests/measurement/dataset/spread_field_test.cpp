#include "rubsweep/measurement/dataset/spread_field.hpp"

#include <gtest/gtest.h>

#include "measurement/dataset/parsed.hpp"

namespace rubsweep::config::dataset {
namespace {

std::string read(const std::string& text, bool logarithmic, diagnose::Spread& spread) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    read_spread(section, "k", model::Range{.low = 0, .high = 10}, logarithmic, spread);
    section.refuse_unknown_keys();
  });
}

TEST(SpreadField, NumberIsKnown) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: 3\n", true, spread), "none");
  EXPECT_EQ(spread.low, 3);
  EXPECT_EQ(spread.high, 3);
}

TEST(SpreadField, ListOfTwoIsAnInterval) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: [1, 4]\n", true, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2);
  EXPECT_EQ(read("k: [1, 4]\n", false, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2.5);
}

TEST(SpreadField, MissingKeyLeavesTheUsualInterval) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("{}\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

TEST(SpreadField, RefusesWhatIsNoIntervalWithItsPlace) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("k: [4, 1]\n", false, spread),
            "study.yaml:1:4: k: begins above its end, allowed: [low, high]");
  EXPECT_NE(read("k: [0, 1]\n", true, spread).find("study.yaml:1:4: k: begins at 0"), std::string::npos);
  EXPECT_NE(read("k: [1, 11]\n", false, spread).find("study.yaml:1:4: k: goes out of range"),
            std::string::npos);
  EXPECT_NE(read("k: 11\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, 2, 3]\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, x]\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

}  // namespace
}  // namespace rubsweep::config::dataset
