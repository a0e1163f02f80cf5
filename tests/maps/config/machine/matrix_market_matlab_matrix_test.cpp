#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "maps/matlab/matio_file.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/config/machine/matrix_market.hpp"

namespace rubsweep::config::machine {
namespace {

/// A MATLAB file to which a test writes variables one by one.
struct MatlabFile : matlab::MatioFile {
  explicit MatlabFile(const std::filesystem::path& path, mat_ft version = MAT_FT_MAT5)
      : MatioFile(path, version) {}

  void single(const char* name, std::vector<float> values) {
    write(variable(name, MAT_C_SINGLE, MAT_T_SINGLE, 2, 2, std::move(values)));
  }
};

struct Answer {
  std::optional<Eigen::MatrixXd> matrix;
  std::string problem;
};

Answer read(const std::filesystem::path& file, const std::string& variable) {
  yaml::Diagnostics diagnostics("my.yaml", {});
  const yaml::Node node{yaml::Node::Kind::scalar, {-1, 3, 7}, variable};
  const std::string bytes = batch::read_input(file);
  Answer answer{read_matlab_matrix(bytes, variable, {node, "rotor.mass.variable", diagnostics}), ""};
  if (diagnostics.count() > 0)
    answer.problem = ::message_of<ConfigError>([&] { diagnostics.throw_if_any(); });
  return answer;
}

TEST(MatrixMarketMatlabMatrix, ReadsFullSingleAndSparseOnes) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "m.mat";
  {
    MatlabFile file(path);
    file.doubles("K", 2, 2, {1, -3, 2, 1.0 / 3});
    file.single("M", {0.5F, 0, 0, 0.25F});
    file.sparse("C");
  }
  EXPECT_EQ(read(path, "K").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{1, 2}, {-3, 1.0 / 3}}));
  EXPECT_EQ(read(path, "M").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{0.5, 0}, {0, 0.25}}));
  EXPECT_EQ(read(path, "C").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{1, -3}, {0, 4.5}}));
}

TEST(MatrixMarketMatlabMatrix, SaysWhatIsNoMatrixOfIt) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "m.mat";
  {
    MatlabFile file(path);
    file.doubles("stiffness", 2, 2, {1, 0, 0, 1});
    file.doubles("wide", 2, 3, {1, 2, 3, 4, 5, 6});
    file.phasor("phasor");
    file.doubles("broken", 1, 1, {NAN});
    file.text("note");
  }
  const std::string at = "my.yaml:3:7: rotor.mass.variable: ",
                    allowed = ", allowed: a square matrix of real numbers, full or sparse";
  EXPECT_EQ(read(path, "stifness").problem, at + "the file holds no 'stifness' (did you mean 'stiffness'?), "
                                                 "allowed: variable: with one of stiffness, "
                                                 "wide, phasor, broken, note");
  EXPECT_EQ(read(path, "wide").problem, at + "'wide' is 2 x 3" + allowed);
  EXPECT_EQ(read(path, "phasor").problem, at + "'phasor' is complex" + allowed);
  EXPECT_EQ(read(path, "broken").problem, at + "'broken' holds a number that is not finite" + allowed);
  EXPECT_EQ(read(path, "note").problem, at + "'note' is 1 x 3" + allowed);
  std::ofstream(directory.path() / "no.mat") << "neither";
  EXPECT_EQ(read(directory.path() / "no.mat", "K").problem,
            at + "the file is no MATLAB file, or a damaged one, allowed: a file of version 4, 5 or 7.3");
}

}  // namespace
}  // namespace rubsweep::config::machine
