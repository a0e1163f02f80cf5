#include "rubsweep/config/machine/matlab_matrix.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "batch/message_of.hpp"
#include "batch/temporary_directory.hpp"
#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::config::machine {
namespace {

/// A MATLAB file that a test writes variable by variable.
class MatlabFile {
 public:
  explicit MatlabFile(const std::filesystem::path& path, mat_ft version = MAT_FT_MAT5)
      : file_(Mat_CreateVer(path.c_str(), nullptr, version)) {}
  ~MatlabFile() { Mat_Close(file_); }
  MatlabFile(const MatlabFile&) = delete;
  MatlabFile& operator=(const MatlabFile&) = delete;

  /// Column by column.
  void full(const char* name, std::size_t rows, std::size_t columns, std::vector<double> values,
            int options = 0) {
    std::array<std::size_t, 2> size{rows, columns};
    std::vector<double> imaginary(values.size(), 1);
    mat_complex_split_t both{values.data(), imaginary.data()};
    void* data = options == MAT_F_COMPLEX ? static_cast<void*>(&both) : values.data();
    write(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), data, options));
  }

  void single(const char* name, std::vector<float> values) {
    std::array<std::size_t, 2> size{2, 2};
    write(Mat_VarCreate(name, MAT_C_SINGLE, MAT_T_SINGLE, 2, size.data(), values.data(), 0));
  }

  void text(const char* name, std::string letters) {
    std::array<std::size_t, 2> size{1, letters.size()};
    write(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, size.data(), letters.data(), 0));
  }

  /// {{1, -3}, {0, 4.5}}
  void sparse(const char* name) {
    std::array<std::size_t, 2> size{2, 2};
    std::array<mat_uint32_t, 3> rows{0, 0, 1}, begins{0, 1, 3};
    std::array<double, 3> values{1, -3, 4.5};
    mat_sparse_t stored{};
    stored.nzmax = stored.nir = stored.ndata = 3;
    stored.ir = rows.data(), stored.njc = 3, stored.jc = begins.data(), stored.data = values.data();
    write(Mat_VarCreate(name, MAT_C_SPARSE, MAT_T_DOUBLE, 2, size.data(), &stored, MAT_F_DONT_COPY_DATA));
  }

 private:
  void write(matvar_t* variable) {
    ASSERT_NE(variable, nullptr);
    ASSERT_EQ(Mat_VarWrite(file_, variable, MAT_COMPRESSION_NONE), 0);
    Mat_VarFree(variable);
  }

  mat_t* file_;
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

TEST(MatlabMatrix, ReadsFullSingleAndSparseOnes) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "m.mat";
  {
    MatlabFile file(path);
    file.full("K", 2, 2, {1, -3, 2, 1.0 / 3});
    file.single("M", {0.5F, 0, 0, 0.25F});
    file.sparse("C");
  }
  EXPECT_EQ(read(path, "K").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{1, 2}, {-3, 1.0 / 3}}));
  EXPECT_EQ(read(path, "M").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{0.5, 0}, {0, 0.25}}));
  EXPECT_EQ(read(path, "C").matrix, Eigen::MatrixXd(Eigen::Matrix2d{{1, -3}, {0, 4.5}}));
}

TEST(MatlabMatrix, SaysWhatIsNoMatrixOfIt) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "m.mat";
  {
    MatlabFile file(path);
    file.full("stiffness", 2, 2, {1, 0, 0, 1});
    file.full("wide", 2, 3, {1, 2, 3, 4, 5, 6});
    file.full("phasor", 1, 1, {1}, MAT_F_COMPLEX);
    file.full("broken", 1, 1, {NAN});
    file.text("note", "ab");
  }
  const std::string at = "my.yaml:3:7: rotor.mass.variable: ",
                    allowed = ", allowed: a square matrix of real numbers, full or sparse";
  EXPECT_EQ(read(path, "stifness").problem, at + "the file holds no 'stifness' (did you mean 'stiffness'?), "
                                                 "allowed: variable: with one of stiffness, "
                                                 "wide, phasor, broken, note");
  EXPECT_EQ(read(path, "wide").problem, at + "'wide' is 2 x 3" + allowed);
  EXPECT_EQ(read(path, "phasor").problem, at + "'phasor' is complex" + allowed);
  EXPECT_EQ(read(path, "broken").problem, at + "'broken' holds a number that is not finite" + allowed);
  EXPECT_EQ(read(path, "note").problem, at + "'note' is 1 x 2" + allowed);
  std::ofstream(directory.path() / "no.mat") << "neither";
  EXPECT_EQ(read(directory.path() / "no.mat", "K").problem,
            at + "the file is no MATLAB file, or a damaged one, allowed: a file of version 4, 5 or 7.3");
}

}  // namespace
}  // namespace rubsweep::config::machine
