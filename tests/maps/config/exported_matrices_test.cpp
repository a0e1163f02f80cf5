#include "rubsweep/maps/config/exported_matrices.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"
#include "rubsweep/maps/config/print_config.hpp"

namespace rubsweep::config {
namespace {

std::string plain_kit() {
  std::string text = test_file("bad/table_missing.yaml");
  return replaced(text, "table: {file: tables/no_such_table.csv}",
                  "stiffness_x_n_per_m: 3.0e4\n      stiffness_y_n_per_m: 3.1e4");
}

TEST(ExportedMatrices, ReadBackAsTheSameReducedRotor) {
  const RunConfig typed = read_run_config_text(plain_kit(), "kit.yaml", {});
  const TemporaryDirectory directory;
  const auto files = exported_matrices(typed);
  ASSERT_EQ(files.size(), std::size(exported_matrix_files));
  for (const std::string_view name : exported_matrix_files) {
    ASSERT_TRUE(files.contains(name)) << name;
    std::ofstream(directory.path() / name) << files.at(name);
  }
  const RunConfig read = read_run_config(directory.path() / "rotor.yaml", {});
  EXPECT_EQ(read.output_directory, "results_matrices");
  EXPECT_EQ(read.study.grid.speed_hz, typed.study.grid.speed_hz);
  const structure::Assembly a = structure::assemble_rotor_kit(typed.study.machine).assembly,
                            b = structure::assemble_rotor_kit(read.study.machine).assembly;
  EXPECT_EQ(a.system.mass, b.system.mass);
  EXPECT_EQ(a.system.stiffness, b.system.stiffness);
  EXPECT_EQ(a.system.damping, b.system.damping);
  EXPECT_EQ(a.gyroscopic, b.gyroscopic);
  EXPECT_EQ(a.system.unbalance_kg, b.system.unbalance_kg);
  EXPECT_EQ(exported_matrices(read),
            exported_matrices(read_run_config_text(print_config(read), "printed.yaml", {})));
}

TEST(ExportedMatrices, OfARotorThatIsVariedAreRefused) {
  const RunConfig config = read_run_config_text(plain_kit(), "kit.yaml",
                                                {"sweep.x={key: rotor.discs.0.mass_kg, values: [0.7, 0.8]}"});
  EXPECT_EQ(::message_of<ConfigError>([&] { exported_matrices(config); }),
            "rotor.discs.0.mass_kg: is varied, and matrices are of one rotor, allowed: keys of other parts "
            "of the machine");
}

}  // namespace
}  // namespace rubsweep::config
