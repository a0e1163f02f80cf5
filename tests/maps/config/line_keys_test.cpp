#include "rubsweep/maps/config/line_keys.hpp"

#include <gtest/gtest.h>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/print_config.hpp"
#include "rubsweep/maps/config/read_run_config.hpp"

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

}  // namespace
}  // namespace rubsweep::config
