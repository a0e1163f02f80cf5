#include "rubsweep/maps/config/machine/matrix_market.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::config::machine {
namespace {

std::optional<Eigen::MatrixXd> read(const std::string& text, yaml::Diagnostics& diagnostics,
                                    bool quoted = false) {
  const int file = diagnostics.add_file("m.mtx");
  const yaml::Node node{yaml::Node::Kind::scalar, {-1, 1, 1, file}, text, quoted};
  return read_matrix_market({node, "rotor.mass", diagnostics});
}

Eigen::MatrixXd matrix(const std::string& text) {
  yaml::Diagnostics diagnostics("my.yaml", {});
  const auto found = read(text, diagnostics);
  diagnostics.throw_if_any();
  return found.value();
}

std::string problem(const std::string& text, bool quoted = false) {
  yaml::Diagnostics diagnostics("my.yaml", {});
  EXPECT_FALSE(read(text, diagnostics, quoted));
  EXPECT_EQ(diagnostics.count(), 1U);
  return ::message_of<ConfigError>([&] { diagnostics.throw_if_any(); });
}

TEST(MatrixMarket, ReadsEveryForm) {
  const Eigen::Matrix2d general{{1, 2}, {-3, 4.5}}, symmetric{{1, -3}, {-3, 4.5}}, skew{{0, 3}, {-3, 0}};
  EXPECT_EQ(
      matrix("%%MatrixMarket matrix coordinate real general\n% by hand\n\n2 2 4\n1 1 1\n1 2 2\r\n2 1 -3\n2 2 "
             "4.5e0\n\n"),
      general);
  EXPECT_EQ(matrix("%%MatrixMarket matrix array real general\n2 2\n1\n-3\n2\n4.5\n"), general);
  EXPECT_EQ(matrix("%%MatrixMarket MATRIX Coordinate Real Symmetric\n2 2 3\n1 1 1\n2 1 -3\n2 2 4.5"),
            symmetric);
  EXPECT_EQ(matrix("%%MatrixMarket matrix array real symmetric\n2 2\n1 -3\n4.5\n"), symmetric)
      << "two in a line";
  EXPECT_EQ(matrix("%%MatrixMarket matrix coordinate integer skew-symmetric\n2 2 1\n2 1 -3\n"), skew);
  EXPECT_EQ(matrix("%%MatrixMarket matrix array real skew-symmetric\n2 2\n-3\n"), skew);
}

TEST(MatrixMarket, NamesTheLineOfEachProblem) {
  const std::string head = "%%MatrixMarket matrix coordinate real symmetric\n";
  EXPECT_EQ(
      problem("1 2 3\n"),
      "m.mtx:1:1: rotor.mass: does not begin as a Matrix Market file, allowed: %%MatrixMarket matrix, then "
      "coordinate or array, real or integer, general, symmetric or skew-symmetric");
  EXPECT_EQ(problem("%%MatrixMarket matrix coordinate complex general\n"),
            "m.mtx:1:34: rotor.mass: 'complex' is not read, allowed: real, integer");
  EXPECT_EQ(problem("%%MatrixMarket matrix array real hermitian\n"),
            "m.mtx:1:34: rotor.mass: 'hermitian' is not read, allowed: general, symmetric, skew-symmetric");
  EXPECT_EQ(problem(head + "2 2\n"),
            "m.mtx:2:1: rotor.mass: the size is missing, allowed: rows, columns and number of entries");
  EXPECT_EQ(problem(head + "2 3 1\n1 1 1\n"),
            "m.mtx:2:3: rotor.mass: the matrix has 2 rows and 3 columns, allowed: as many columns as rows");
  EXPECT_EQ(problem(head + "% larger than any\n100000 100000 0\n"),
            "m.mtx:3:1: rotor.mass: '100000' is no number of a row or column here, allowed: an integer from "
            "1 to 2000");
  EXPECT_EQ(problem(head + "2 2 2\n1 1 1\n"),
            "m.mtx:3:1: rotor.mass: the matrix ends after 1 entries, allowed: 2 entries");
  EXPECT_EQ(problem(head + "2 2 1\n1 1 1\n2 2 1\n"),
            "m.mtx:4:1: rotor.mass: the matrix goes on, allowed: 1 entries");
  EXPECT_EQ(
      problem(head + "2 2 1\n1 2 1\n"),
      "m.mtx:3:3: rotor.mass: the entry stands above the diagonal of a symmetric matrix, allowed: the lower "
      "triangle alone");
  EXPECT_EQ(problem("%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 2 1\n"),
            "m.mtx:3:3: rotor.mass: the entry does not stand below the diagonal of a skew-symmetric matrix, "
            "allowed: the "
            "strictly lower triangle alone");
  EXPECT_EQ(problem(head + "2 2 2\n2 1 1\n2 1 1\n"),
            "m.mtx:4:1: rotor.mass: row 2, column 1 is given twice, allowed: each entry once");
  EXPECT_EQ(
      problem(head + "2 2 1\n3 1 1\n"),
      "m.mtx:3:1: rotor.mass: '3' is no number of a row or column here, allowed: an integer from 1 to 2");
  EXPECT_EQ(problem(head + "2 2 1\n1 1 nan\n"),
            "m.mtx:3:5: rotor.mass: 'nan' is no finite number, allowed: a decimal number such as 1.5e6");
  EXPECT_EQ(problem(head + "2 2 1\n1 1\n"),
            "m.mtx:3:1: rotor.mass: the line has 2 numbers, allowed: row, column and value");
  const std::string array = "%%MatrixMarket matrix array real general\n2 2\n";
  EXPECT_EQ(problem(array + "1\n2\n3\n"),
            "m.mtx:5:1: rotor.mass: the matrix ends too soon, allowed: the numbers of 2 columns");
  EXPECT_EQ(problem(array + "1\n2\n3\n4 5\n"),
            "m.mtx:6:3: rotor.mass: the matrix goes on, allowed: the numbers of 2 columns");
  EXPECT_EQ(
      problem(array + "1\n2\n3\n4,5\n", true),
      "m.mtx:1:1: rotor.mass: line 6: '4,5' is no finite number, allowed: a decimal number such as 1.5e6");
}

TEST(MatrixMarket, IsWrittenInTheShorterFormAndReadBackToTheBit) {
  Eigen::MatrixXd sparse = Eigen::MatrixXd::Zero(5, 5);
  sparse(0, 0) = 1.0 / 3, sparse(3, 1) = sparse(1, 3) = -2e-300, sparse(4, 4) = 1e22;
  EXPECT_EQ(matrix_market(sparse),
            "%%MatrixMarket matrix coordinate real symmetric\n5 5 3\n1 1 0.3333333333333333\n4 2 -2e-300\n5 "
            "5 1e+22\n");
  EXPECT_EQ(matrix(matrix_market(sparse)), sparse);
  const Eigen::Matrix2d skew{{0, 0.1}, {-0.1, 0}}, full{{0.1, 0.2}, {0.3, 0.7}};
  EXPECT_EQ(matrix_market(skew), "%%MatrixMarket matrix array real skew-symmetric\n2 2\n-0.1\n");
  EXPECT_EQ(matrix(matrix_market(skew)), skew);
  EXPECT_EQ(matrix_market(full), "%%MatrixMarket matrix array real general\n2 2\n0.1\n0.3\n0.2\n0.7\n");
  EXPECT_EQ(matrix(matrix_market(full)), full);
  const Eigen::Matrix2d nothing = Eigen::Matrix2d::Zero();
  EXPECT_EQ(matrix(matrix_market(nothing)), nothing);
}

}  // namespace
}  // namespace rubsweep::config::machine
