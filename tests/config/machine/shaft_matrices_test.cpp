#include "rubsweep/config/machine/shaft_matrices.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <array>

#include "config/machine/matrix_text.hpp"
#include "rubsweep/config/print_config.hpp"
#include "structure/hand_matrices.hpp"

namespace rubsweep::config::machine {
namespace {

const model::ShaftMatrices& matrices_of(const RunConfig& config) {
  return *model::kit_of(config.study.machine)->matrices;
}

void expect_same(const model::ShaftMatrices& a, const model::ShaftMatrices& b) {
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.gyroscopic, b.gyroscopic);
  ASSERT_EQ(a.degrees_of_freedom.size(), b.degrees_of_freedom.size());
  for (std::size_t i = 0; i < a.degrees_of_freedom.size(); ++i) {
    const model::DegreeOfFreedom &one = a.degrees_of_freedom[i], &other = b.degrees_of_freedom[i];
    EXPECT_EQ(one.node, other.node);
    EXPECT_EQ(one.direction, other.direction);
    EXPECT_EQ(one.position_m, other.position_m);
    EXPECT_EQ(one.weight_kg, other.weight_kg);
  }
  EXPECT_EQ(a.unbalance_kg, b.unbalance_kg);
}

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

TEST(ShaftMatrices, LeaveOutWhatIsNothing) {
  const MatrixFiles files;
  model::ShaftMatrices plain = structure::disc_and_bracket();
  plain.damping.setZero();
  plain.unbalance_kg.setZero();
  files.write(plain);
  const std::string printed = print_config(files.read());
  EXPECT_EQ(printed.find("damping: |"), std::string::npos);
  EXPECT_EQ(printed.find("gyroscopic"), std::string::npos);
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

/// As many as a large model of beams has; every matrix is a band.
TEST(ShaftMatrices, OfFourHundredDegreesOfFreedomArePrintedAndReadBack) {
  const MatrixFiles files;
  std::vector<double> places;
  for (int i = 0; i < 100; ++i) places.push_back(0.01 * i);
  model::ShaftMatrices large = structure::empty_matrices(structure::freedoms_at(places));
  for (Eigen::Index i = 0; i + 8 <= 400; i += 4) {
    const structure::BookElement element = structure::book_element(0.01, 0.05);
    large.mass.block<8, 8>(i, i) += element.mass;
    large.stiffness.block<8, 8>(i, i) += element.stiffness;
    large.gyroscopic.block<8, 8>(i, i) += element.gyroscopic;
  }
  large.stiffness.diagonal().array() += 1e3;
  files.write(large);
  const std::string printed = print_config(files.read());
  expect_same(matrices_of(read_run_config_text(printed, "printed.yaml", {})), large);
  // Full matrices, as a program that condenses has them: as an array each of them has 1.6 MB.
  large.damping = Eigen::MatrixXd::Constant(400, 400, 1.0 / 3);
  large.stiffness.array() += 1.0 / 3;
  files.write(large);
  const std::string full = print_config(files.read());
  EXPECT_GT(full.size(), 2'000'000U);
  EXPECT_EQ(matrices_of(read_run_config_text(full, "printed.yaml", {})).stiffness,
            matrices_of(files.read()).stiffness);
}

}  // namespace
}  // namespace rubsweep::config::machine
