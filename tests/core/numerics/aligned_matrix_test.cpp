#include "rubsweep/core/numerics/aligned_matrix.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "rubsweep/core/numerics/matrix_vector.hpp"

namespace rubsweep::numerics {
namespace {

/// Also behind a copy and a move, which have memory of their own.
TEST(AlignedMatrix, BeginsEveryColumnWithACacheLine) {
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

TEST(AlignedMatrix, HasTheNumbersOfTheMatrix) {
  for (Eigen::Index rows = 1; rows <= 20; ++rows) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(rows, 7);
    const AlignedMatrix aligned(matrix);
    EXPECT_EQ(aligned.diagonal(), matrix.diagonal());
    const Eigen::VectorXd vector = Eigen::VectorXd::Random(7);
    EXPECT_EQ(product_of<Eigen::VectorXd>(aligned, vector), product_of<Eigen::VectorXd>(matrix, vector));
  }
}

}  // namespace
}  // namespace rubsweep::numerics
