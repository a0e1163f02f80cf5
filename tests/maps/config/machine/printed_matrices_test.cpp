#include "rubsweep/maps/config/machine/printed_matrices.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/structure/hand_matrices.hpp"
#include "maps/config/machine/matrix_text.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

TEST(PrintedMatrices, LeaveOutWhatIsNothing) {
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

/// As many degrees of freedom as a large beam model has; every matrix is banded.
TEST(PrintedMatrices, OfFourHundredDegreesOfFreedomArePrintedAndReadBack) {
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
  // Full matrices, as from a program that condenses a model; each array takes 1.6 MB.
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
