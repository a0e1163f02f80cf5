#include "rubsweep/core/structure/matrix_layout.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "core/structure/hand_matrices.hpp"

namespace rubsweep::structure {
namespace {

TEST(MatrixLayout, HasASlopeThatTheMatricesLeaveOut) {
  const model::ShaftMatrices matrices = disc_and_bracket();
  const MatrixLayout layout = layout_of(matrices);
  EXPECT_EQ(layout.coordinates(), 3);
  EXPECT_FALSE(layout.plane[0][1].freedom);
  EXPECT_EQ(layout.plane[1][2].freedom, Eigen::Index{3});
  EXPECT_EQ(layout.bodies, (std::vector<Eigen::Index>{2}));
  Eigen::Matrix3d cross;
  cross << 3e3, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(block(matrices.stiffness, layout, 0, 1), cross);
}

TEST(MatrixLayout, CountsAnglesAboutXTheOtherWay) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({0.3}));
  matrices.stiffness(1, 2) = 7;
  const MatrixLayout layout = layout_of(matrices);
  EXPECT_EQ(block(matrices.stiffness, layout, 1, 1), (Eigen::Matrix2d{{0, -7}, {0, 0}}));
}

TEST(MatrixLayout, NamesTheUnbalanceThatDoesNotTurn) {
  model::ShaftMatrices matrices = disc_and_bracket();
  EXPECT_FALSE(turning_unbalance(matrices, layout_of(matrices)).wrong);
  matrices.unbalance_kg(1) = std::complex<double>(0, 2);
  EXPECT_EQ(turning_unbalance(matrices, layout_of(matrices)).wrong, std::size_t{1});
}

}  // namespace
}  // namespace rubsweep::structure
