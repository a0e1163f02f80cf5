#include "rubsweep/maps/config/yaml/differing_keys.hpp"

#include <gtest/gtest.h>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::yaml {
namespace {

using Lines = std::vector<std::string>;

std::string study(const std::vector<std::string>& overrides) {
  return print_study(read_run_config(CONFIG_TEST_DATA "/minimal.yaml", overrides).study);
}

TEST(DifferingKeys, OfEqualStudiesAreNone) { EXPECT_EQ(differing_keys(study({}), study({})), Lines{}); }

TEST(DifferingKeys, NameBothValues) {
  const std::string there = study({"rotor.mass_kg=0.8", "solver.stepper=dopri5"});
  const std::string here = study({"rotor.mass_kg=0.81", "solver.stepper=rkf78"});
  EXPECT_EQ(differing_keys(there, here),
            (Lines{"rotor.mass_kg: 0.8 there, 0.81 here", "solver.stepper: dopri5 there, rkf78 here"}));
}

TEST(DifferingKeys, MayBeThereInOneOnly) {
  EXPECT_EQ(differing_keys("a: 1\nstops:\n  - b: 2\n", "stops:\n  - b: 2\n    c: x\n  - b: 3\n"),
            (Lines{"a: 1 there, not set here", "stops.0.c: not set there, x here",
                   "stops.1.b: not set there, 3 here"}));
}

TEST(DifferingKeys, ShowLongListsWhereTheyDiffer) {
  std::string there = "[", here = "[";
  for (int i = 100; i < 200; ++i) {
    there += std::to_string(i) + ", ";
    here += std::to_string(i == 150 ? 999 : i) + ", ";
  }
  const Lines lines = differing_keys("speeds: " + there + "0]", "speeds: " + here + "0]");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].find("speeds: ...146, 147, 148, 149, 150, "), 0u) << lines[0];
  EXPECT_NE(lines[0].find(" there, ...146, 147, 148, 149, 999, "), std::string::npos) << lines[0];
}

TEST(DifferingKeys, SayHowLongListsAreSpaced) {
  EXPECT_EQ(
      differing_keys(study({"sweep.speed_hz={from: 50, to: 150, count: 2000}"}),
                     study({"sweep.speed_hz={from: 50, to: 151, count: 1000}"})),
      Lines{"sweep.speed_hz.values: 2000 values from 50 to 150 there, 1000 values from 50 to 151 here"});
}

}  // namespace
}  // namespace rubsweep::config::yaml
