#include "rubsweep/core/structure/matrix_shaft.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <limits>

#include "core/structure/hand_matrices.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::structure {
namespace {

TEST(MatrixShaft, PartsThePlanesOfADiscAndABracket) {
  const BeamShaft shaft = matrix_shaft(disc_and_bracket());
  ASSERT_EQ(shaft.coordinates(), 3) << "the disc's deflection, a slope that nothing bends, the bracket";
  EXPECT_EQ(shaft.node_position_m, (std::vector<double>{0.5}));
  EXPECT_EQ(shaft.deflection(0.5), 0);
  EXPECT_EQ(shaft.housings, (std::vector<Eigen::Index>{2}));
  Eigen::Matrix3d x, y, cross_x, cross_y;
  x << 1e5, 0, -2e4, 0, 1, 0, -2e4, 0, 5e4;
  y << 2e5, 0, -2e4, 0, 1, 0, -2e4, 0, 6e4;
  cross_x << 3e3, 0, 0, 0, 0, 0, 0, 0, 0;
  cross_y << -4e3, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(shaft.plane_stiffness(0), x);
  EXPECT_EQ(shaft.plane_stiffness(1), y);
  EXPECT_EQ(shaft.support_stiffness[0][1], cross_x);
  EXPECT_EQ(shaft.support_stiffness[1][0], cross_y);
  EXPECT_EQ(shaft.plane_mass(0), Eigen::Matrix3d(Eigen::Vector3d(2, 0, 5).asDiagonal()));
  EXPECT_EQ(shaft.support_damping[1][1], Eigen::Matrix3d(Eigen::Vector3d(20, 0, 40).asDiagonal()));
  EXPECT_EQ(shaft.weight_kg, Eigen::Vector3d(2, 0, 5));
  EXPECT_EQ(shaft.unbalance_kg, Eigen::Vector3cd(2, 0, 0));
}

TEST(MatrixShaft, TurnsAnglesAboutXIntoSlopes) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({0.3}));
  matrices.mass.diagonal() << 3, 3, 0.1, 0.1;
  matrices.stiffness.diagonal() << 1e6, 1e6, 1e3, 1e3;
  // The disc at the end of a cantilever of length l, E I = l = 1: K_ws = -6, by 1e2. In y the slope is -rx.
  matrices.stiffness(0, 3) = matrices.stiffness(3, 0) = -6e2;
  matrices.stiffness(1, 2) = matrices.stiffness(2, 1) = 6e2;
  matrices.gyroscopic(2, 3) = 0.2, matrices.gyroscopic(3, 2) = -0.2;
  matrices.degrees_of_freedom[2].weight_kg = 0.25;
  const std::complex<double> i(0, 1);
  matrices.unbalance_kg << 0.1, -i * 0.1, i * 0.02, 0.02;
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.plane_stiffness(0), shaft.plane_stiffness(1));
  EXPECT_EQ(shaft.plane_stiffness(1)(0, 1), -6e2);
  EXPECT_EQ(shaft.gyroscopic, (Eigen::Matrix2d{{0, 0}, {0, 0.2}}));
  EXPECT_EQ(shaft.unbalance_kg, Eigen::Vector2cd(0.1, 0.02));
  EXPECT_EQ(shaft.weight_kg, Eigen::Vector2d(3, -0.25));
}

TEST(MatrixShaft, SortsNodesByTheirPlaceAndKeepsTheOrderOfTwoAtOne) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({1, 0, 0.5, 0.5}));
  for (Eigen::Index i = 0; i < 16; ++i)
    matrices.mass(i, i) = matrices.stiffness(i, i) = static_cast<double>(1 + i / 4);
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.node_position_m, (std::vector<double>{0, 0.5, 0.5, 1}));
  const Eigen::VectorXd found = shaft.plane_stiffness(1).diagonal();
  EXPECT_EQ(found, (Eigen::VectorXd(8) << 2, 2, 3, 3, 4, 4, 1, 1).finished());
}

TEST(MatrixShaft, TakesTheUnbalanceOfOnePlaneForBoth) {
  model::ShaftMatrices matrices = disc_and_bracket();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  matrices.unbalance_kg(0) = {unknown, unknown};
  EXPECT_EQ(matrix_shaft(matrices).unbalance_kg, Eigen::Vector3cd(2, 0, 0));
  matrices.unbalance_kg(0) = 2, matrices.unbalance_kg(1) = {unknown, unknown};
  EXPECT_EQ(matrix_shaft(matrices).unbalance_kg, Eigen::Vector3cd(2, 0, 0));
  matrices.unbalance = {{"disc", 3, 0.5, 90}};
  const std::complex<double> sum = matrix_shaft(matrices).unbalance_kg(0);
  EXPECT_NEAR(std::abs(sum - std::complex<double>(2, 1.5)), 0, 1e-15);
}

TEST(MatrixShaft, IsSymmetricWhereRoundingLeftTheMatrixUneven) {
  model::ShaftMatrices matrices = disc_and_bracket();
  matrices.stiffness(0, 2) *= 1 + 1e-12;
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.plane_stiffness(0)(0, 2), shaft.plane_stiffness(0)(2, 0));
}

TEST(MatrixShaft, ThrowsTheFirstProblemToUsersOfTheLibrary) {
  model::ShaftMatrices matrices = disc_and_bracket();
  matrices.mass.setZero();
  EXPECT_EQ(message_of<ConfigError>([&] { matrix_shaft(matrices); }),
            "rotor.mass: is zero, allowed: a positive definite matrix");
}

}  // namespace
}  // namespace rubsweep::structure
