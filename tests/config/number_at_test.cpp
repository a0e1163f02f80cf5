#include "rubsweep/config/number_at.hpp"

#include <gtest/gtest.h>

#include "rubsweep/config/read_run_config.hpp"

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

}  // namespace
}  // namespace rubsweep::config
