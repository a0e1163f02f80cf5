#include "rubsweep/core/numerics/matrix_vector.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>

namespace rubsweep::numerics {
namespace {

/// The alignment also holds for copies and moved matrices, which have their own memory.
TEST(MatrixVectorAlignedMatrix, BeginsEveryColumnWithACacheLine) {
  for (const Eigen::Index rows : {1, 8, 19, 40}) {
    const AlignedMatrix made(Eigen::MatrixXd::Random(rows, 5));
    AlignedMatrix copy = made;
    const AlignedMatrix moved = std::move(copy);
    for (const AlignedMatrix* matrix : {&made, &moved}) {
      for (Eigen::Index j = 0; j < matrix->cols(); ++j)
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(matrix->data() + j * matrix->stride()) % 64, 0u) << rows;
    }
  }
  EXPECT_EQ(AlignedMatrix().data(), nullptr);
}

TEST(MatrixVectorAlignedMatrix, HasTheNumbersOfTheMatrix) {
  for (Eigen::Index rows = 1; rows <= 20; ++rows) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, 7);
    const AlignedMatrix aligned(matrix);
    EXPECT_EQ(aligned.diagonal(), matrix.diagonal());
    const Eigen::VectorXd vector = Eigen::VectorXd::Random(7);
    EXPECT_EQ(product_of<Eigen::VectorXd>(aligned, vector), product_of<Eigen::VectorXd>(matrix, vector));
  }
}

/// Tests every number of lanes with every remainder of rows, including non-square matrices.
TEST(MatrixVector, HasTheBitsOfThePlainSum) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> entries(-1, 1);
  for (Eigen::Index rows = 1; rows <= 60; ++rows) {
    const Eigen::Index columns = 1 + (7 * rows) % 31;
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return entries(random); });
    const Eigen::VectorXd vector = Eigen::VectorXd::NullaryExpr(columns, [&] { return entries(random); });
    const auto product = product_of<Eigen::VectorXd>(matrix, vector);
    ASSERT_EQ(product.size(), rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      double sum = matrix(i, 0) * vector(0);
      for (Eigen::Index k = 1; k < columns; ++k) sum += matrix(i, k) * vector(k);
      EXPECT_EQ(product(i), sum) << rows << " x " << columns;
    }
  }
}

TEST(MatrixVector, IsEigensProductWhereSizesAreKnown) {
  const Eigen::Matrix4d matrix = Eigen::Matrix4d::Random();
  const Eigen::Vector4d vector = Eigen::Vector4d::Random();
  EXPECT_LT((product_of<Eigen::Vector4d>(matrix, vector) - matrix * vector).norm(), 1e-15);
  EXPECT_EQ(product_of<Eigen::VectorXd>(Eigen::MatrixXd(matrix), vector),
            (product_of<Eigen::Vector4d>(matrix, vector)));
}

}  // namespace

}  // namespace rubsweep::numerics
