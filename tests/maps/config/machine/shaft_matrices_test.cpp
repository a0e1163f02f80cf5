#include <gtest/gtest.h>
#include <matio.h>

#include <array>

#include "core/structure/hand_matrices.hpp"
#include "maps/config/machine/matrix_text.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

TEST(ShaftMatrices, AreReadFromFilesAndPrintedInsideTheConfiguration) {
  const MatrixFiles files;
  model::ShaftMatrices written = structure::disc_and_bracket();
  written.gyroscopic(0, 1) = 0.1, written.gyroscopic(1, 0) = -0.1;
  written.degrees_of_freedom[3].weight_kg = -1.5;
  files.write(written);
  const RunConfig config = files.read();
  expect_same(matrices_of(config), written);
  const std::string printed = print_config(config);
  EXPECT_EQ(printed.find(".mtx"), std::string::npos);
  EXPECT_EQ(printed.find(".csv"), std::string::npos);
  EXPECT_NE(printed.find("  kind: matrices\n  mass: |\n    %%MatrixMarket matrix"), std::string::npos)
      << printed;
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  expect_same(matrices_of(again), written);
  EXPECT_EQ(print_config(again), printed);
}

TEST(ShaftMatrices, AreReadFromAMatlabFile) {
  const MatrixFiles files;
  const model::ShaftMatrices written = structure::disc_and_bracket();
  files.write(written);
  {
    mat_t* file = Mat_CreateVer(files.path("model.mat").c_str(), nullptr, MAT_FT_MAT5);
    ASSERT_NE(file, nullptr);
    for (auto [name, matrix] : {std::pair("mass", written.mass), {"K", written.stiffness}}) {
      std::array<std::size_t, 2> size{4, 4};
      matvar_t* variable = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), matrix.data(), 0);
      Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
      Mat_VarFree(variable);
    }
    Mat_Close(file);
  }
  expect_same(matrices_of(files.read(
                  {"rotor.mass={file: model.mat}", "rotor.stiffness={file: model.mat, variable: K}"})),
              written);
  EXPECT_EQ(files.message({"rotor.mass={file: model.mat, variable: M}"}),
            "--set rotor.mass={file: model.mat, variable: M}: rotor.mass.variable: the file holds no 'M' "
            "(did you mean 'K'?), allowed: "
            "variable: with one of mass, K");
  EXPECT_EQ(files.message({"rotor.mass.variable=M"}),
            "--set rotor.mass.variable=M: rotor.mass.variable: is given for a file that is not MATLAB's, "
            "allowed: a file "
            "that ends in .mat");
}

TEST(ShaftMatrices, TakeTheUnbalanceByNode) {
  const MatrixFiles files;
  files.write(structure::disc_and_bracket());
  const RunConfig config =
      files.read({"rotor.unbalance=[{node: disc, mass_kg: 2}, {position_m: 0.5, mass_kg: 1, "
                  "eccentricity_ratio: 0.5, phase_deg: 90}]"});
  const model::ShaftMatrices& read = matrices_of(config);
  ASSERT_EQ(read.unbalance.size(), 2U);
  EXPECT_EQ(read.unbalance[1].node, "disc");
  EXPECT_EQ(read.unbalance[1].phase_deg, 90);
  EXPECT_EQ(model::unbalanced_mass_kg(read), 2.5);
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find(
                "    - node: disc\n      mass_kg: 1\n      eccentricity_ratio: 0.5\n      phase_deg: 90\n"),
            std::string::npos)
      << printed;
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

}  // namespace
}  // namespace rubsweep::config::machine
