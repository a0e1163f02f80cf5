#include "rubsweep/core/numerics/dense/eigenvalues.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace rubsweep::numerics::dense {
namespace {

TEST(Eigenvalues, OfADampedOscillatorAreItsRates) {
  const double ratio = 0.1, rad_per_s = 3;
  const Eigen::MatrixXd generator{{0, 1}, {-rad_per_s * rad_per_s, -2 * ratio * rad_per_s}};
  const Eigen::VectorXcd found = eigenvalues(generator);
  ASSERT_EQ(found.size(), 2);
  for (const std::complex<double>& value : found) {
    EXPECT_NEAR(value.real(), -ratio * rad_per_s, 1e-14);
    EXPECT_NEAR(std::abs(value.imag()), rad_per_s * std::sqrt(1 - ratio * ratio), 1e-14);
  }
  EXPECT_NEAR(spectral_radius(generator), rad_per_s, 1e-14);
}

TEST(Eigenvalues, DoNotDependOnTheUnitOfTime) {
  // An undamped structure with its contact; in time units of 2^-order seconds its eigenvalues are 2^order
  // times smaller.
  const Eigen::Matrix2d stiffness{{4e8, -3e8}, {-5e8, 9e8}};
  const auto in_unit = [&](int order) {
    Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(4, 4);
    generator.topRightCorner(2, 2).setIdentity();
    generator.bottomLeftCorner(2, 2) = -stiffness * std::ldexp(1.0, 2 * order);
    return spectral_radius(generator) * std::ldexp(1.0, -order);
  };
  const double right = std::sqrt((13e8 + std::sqrt(25e16 + 60e16)) / 2);
  for (const int order : {0, 12, 20, 40, -40}) EXPECT_NEAR(in_unit(order), right, 1e-6 * right) << order;
  EXPECT_EQ(in_unit(20), in_unit(30));
}

TEST(EigenvaluesEigenvectors, AreStretchedByTheirValues) {
  const Eigen::MatrixXd matrix{{0, 2, 1}, {-2, 0, 3}, {0, 0, 0.5}};
  const Eigenvectors found = eigenvectors(matrix);
  ASSERT_EQ(found.values.size(), 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::VectorXcd direction = found.vectors.col(i);
    EXPECT_NEAR(direction.norm(), 1, 1e-12);
    EXPECT_LE((matrix * direction - found.values(i) * direction).norm(), 1e-14);
  }
}

TEST(EigenvaluesGeneralModes, SaySoWhenTheIterationIsCutShort) {
  const Eigen::MatrixXd cyclic{{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  EXPECT_FALSE(general_modes(cyclic, false, 0).converged);
  const GeneralModes found = general_modes(cyclic, true);
  ASSERT_TRUE(found.converged);
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(std::abs(found.values(i)), 1, 1e-14);
  EXPECT_LE((cyclic * found.vectors - found.vectors * found.values.asDiagonal()).norm(), 1e-14);
}

TEST(Eigenvalues, SpectralRadiusGoesByTheModulus) {
  EXPECT_NEAR(spectral_radius(Eigen::MatrixXd{{-5, 1}, {0, 4}}), 5, 1e-14);
}

TEST(Eigenvalues, OfWhatIsNotFiniteAreNotKnown) {
  const Eigen::MatrixXd matrix{{1, std::nan("")}, {0, 2}};
  EXPECT_TRUE(eigenvalues(matrix).array().isNaN().all());
  EXPECT_TRUE(eigenvectors(matrix).values.array().isNaN().all());
  EXPECT_FALSE(spectral_radius(matrix) < 1);
  EXPECT_FALSE(spectral_radius(matrix) >= 1);
}

using Eigen::MatrixXd;

TEST(EigenvaluesSelfAdjoint, ModesOfTwoEqualMassesOnThreeSpringsAreInAndOutOfPhase) {
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
