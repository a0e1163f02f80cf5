#include "rubsweep/maps/config/line_keys.hpp"

#include <gtest/gtest.h>

#include "maps/batch/message_of.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {
namespace {

const std::filesystem::path minimal = std::string(CONFIG_TEST_DATA) + "/minimal.yaml";
const std::string one = "sweep.x={key: rotor.mass_kg, values: [2]}",
                  several = "sweep.x={key: rotor.mass_kg, values: [1, 2]}";

TEST(LineKeysCellConfig, AnAxisOfOneValueHoldsIt) {
  const RunConfig config = read_cell_config(minimal, {one});
  EXPECT_TRUE(config.study.grid.axes.empty());
  EXPECT_EQ(print_config(config), print_config(read_run_config(minimal, {"rotor.mass_kg=2"})));
}

TEST(LineKeysCellConfig, OfSeveralValuesOneMustBeSaid) {
  EXPECT_EQ(
      ::message_of<ConfigError>([&] { read_cell_config(minimal, {several}); }),
      "--set " + several +
          ": sweep.x: rotor.mass_kg has 2 values, and a cell has one, allowed: --set rotor.mass_kg=VALUE or "
          "--set sweep.x.values=[VALUE]");
  const RunConfig named = read_cell_config(minimal, {several, "rotor.mass_kg=1.5"});
  EXPECT_EQ(print_config(named), print_config(read_run_config(minimal, {"rotor.mass_kg=1.5"})));
  const RunConfig elsewhere = read_cell_config(minimal, {several}, {"rotor.mass_kg"});
  EXPECT_EQ(print_config(elsewhere), print_config(read_run_config(minimal, {})));
}

TEST(LineKeysCellConfig, WithoutSuchAxesIsTheConfiguration) {
  EXPECT_EQ(print_config(read_cell_config(minimal, {})), print_config(read_run_config(minimal, {})));
}

TEST(LineKeysNumberAt, GivenOnesDefaultsAndThoseOfLists) {
  const RunConfig config = read_run_config(CONFIG_TEST_DATA "/minimal.yaml", {"stops.0.clearance_m=0.0025"});
  EXPECT_EQ(number_at(config, "stops.0.clearance_m"), 0.0025);
  EXPECT_EQ(number_at(config, "solver.relative_tolerance"), config.study.solver.relative_tolerance);
  EXPECT_EQ(number_at(config, "gravity_m_per_s2"), 0);
}

TEST(LineKeysNumberAt, WhatIsNoNumberOrNotThere) {
  const RunConfig config = read_run_config(CONFIG_TEST_DATA "/minimal.yaml", {});
  for (const char* path :
       {"", "rotor", "rotor.kind", "rotor.mass", "stops.7.clearance_m", "stops.x", "rotor.mass_kg.x"})
    EXPECT_FALSE(number_at(config, path)) << path;
}

TEST(LineKeysNumberAt, IsThatOfItsValue) {
  const std::filesystem::path file = std::filesystem::path(CONFIG_TEST_DATA) / "minimal.yaml";
  const std::string name = file.string();
  EXPECT_EQ(place_of_key(file, {}, "rotor.mass_kg"), name + ":2:34");
  EXPECT_EQ(place_of_key(file, {}, "stops.0.angle_deg"), name + ":5:16");
  EXPECT_EQ(place_of_key(file, {"rotor.mass_kg=2"}, "rotor.mass_kg"), "--set rotor.mass_kg=2");
  EXPECT_EQ(place_of_key(file, {}, "kick.force_n"), name);
}

}  // namespace
}  // namespace rubsweep::config
