#include "rubsweep/maps/config/number_at.hpp"

#include <gtest/gtest.h>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/read_run_config.hpp"

namespace rubsweep::config {
namespace {

TEST(NumberAt, GivenOnesDefaultsAndThoseOfLists) {
  const RunConfig config = read_run_config(CONFIG_TEST_DATA "/minimal.yaml", {"stops.0.clearance_m=0.0025"});
  EXPECT_EQ(number_at(config, "stops.0.clearance_m"), 0.0025);
  EXPECT_EQ(number_at(config, "solver.relative_tolerance"), config.study.solver.relative_tolerance);
  EXPECT_EQ(number_at(config, "gravity_m_per_s2"), 0);
}

TEST(NumberAt, WhatIsNoNumberOrNotThere) {
  const RunConfig config = read_run_config(CONFIG_TEST_DATA "/minimal.yaml", {});
  for (const char* path :
       {"", "rotor", "rotor.kind", "rotor.mass", "stops.7.clearance_m", "stops.x", "rotor.mass_kg.x"})
    EXPECT_FALSE(number_at(config, path)) << path;
}

TEST(NumberAt, IsThatOfItsValue) {
  const std::filesystem::path file = std::filesystem::path(CONFIG_TEST_DATA) / "minimal.yaml";
  const std::string name = file.string();
  EXPECT_EQ(place_of_key(file, {}, "rotor.mass_kg"), name + ":2:34");
  EXPECT_EQ(place_of_key(file, {}, "stops.0.angle_deg"), name + ":5:16");
  EXPECT_EQ(place_of_key(file, {"rotor.mass_kg=2"}, "rotor.mass_kg"), "--set rotor.mass_kg=2");
  EXPECT_EQ(place_of_key(file, {}, "kick.force_n"), name);
}

}  // namespace
}  // namespace rubsweep::config
