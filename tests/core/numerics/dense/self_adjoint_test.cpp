#include "rubsweep/core/numerics/dense/self_adjoint.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXd;

TEST(SelfAdjoint, ModesOfTwoEqualMassesOnThreeSpringsAreInAndOutOfPhase) {
  const MatrixXd stiffness{{2, -1}, {-1, 2}};
  const auto modes = self_adjoint_modes(stiffness);
  ASSERT_TRUE(modes.converged);
  EXPECT_NEAR(modes.values(0), 1, 1e-15);
  EXPECT_NEAR(modes.values(1), 3, 1e-15);
  EXPECT_NEAR(modes.vectors(0, 0), modes.vectors(1, 0), 1e-15);
  EXPECT_NEAR(modes.vectors(0, 1), -modes.vectors(1, 1), 1e-15);
  EXPECT_EQ(self_adjoint_eigenvalues(stiffness).size(), 2);
  EXPECT_NEAR(self_adjoint_eigenvalues(stiffness)(1), 3, 1e-15);
}

}  // namespace
}  // namespace rubsweep::numerics::dense
