#include "rubsweep/core/numerics/modal_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::numerics {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;

/// Checks that basis * pairs * inverse equals the generator.
void expect_similar(const MatrixXd& stiffness, const MatrixXd& damping) {
  const auto form = modal_form(stiffness, damping);
  ASSERT_TRUE(form);
  const Eigen::Index n = stiffness.rows();
  MatrixXd pairs = MatrixXd::Zero(2 * n, 2 * n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Pair& p = form->pairs[static_cast<std::size_t>(j)];
    pairs(j, j) = p.uu;
    pairs(j, n + j) = p.uv;
    pairs(n + j, j) = p.vu;
    pairs(n + j, n + j) = p.vv;
  }
  const MatrixXd a = generator_of(stiffness, damping);
  const MatrixXd defect = form->basis * pairs * form->inverse - a;
  EXPECT_LT(defect.cwiseAbs().maxCoeff(), 1e-10 * a.cwiseAbs().maxCoeff());
  EXPECT_LT((form->basis * form->inverse - MatrixXd::Identity(2 * n, 2 * n)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ModalForm, TurnsTheGeneratorIntoPairs) {
  Matrix2d k, c;
  k << 5e4, -4e4, -6e5, 7e5;
  c << 10, -3, -60, 80;
  expect_similar(k, c);
  c *= 100;  // this matrix also has real eigenvalues
  expect_similar(k, c);
  expect_similar(k, Matrix2d::Zero());
}

/// The unrounded basis also gives pairs for a generator whose stiffness cannot be represented in double.
TEST(ModalForm, KnowsMoreDigitsOfItsBasis) {
  LongMatrix k(2, 2), c(2, 2);
  k << 5e4L, -4e4L, -6e5L, 7e5L + 1e-14L;
  c << 10, -3, -60, 80;
  const auto form = modal_form_of_unrounded(k, c);
  ASSERT_TRUE(form);
  EXPECT_EQ(form->basis, form->unrounded_basis.cast<double>());
  const LongMatrix one = form->unrounded_basis * form->unrounded_inverse - LongMatrix::Identity(4, 4);
  EXPECT_LT(one.topLeftCorner(2, 2).cwiseAbs().maxCoeff(), 1e-17L);
  // Displacements and velocities of one vibration: the rate times the displacements gives the velocities.
  LongMatrix generator = LongMatrix::Zero(4, 4);
  generator.topRightCorner(2, 2).setIdentity();
  generator.bottomLeftCorner(2, 2) = -k;
  generator.bottomRightCorner(2, 2) = -c;
  const LongMatrix pairs = form->unrounded_inverse * generator * form->unrounded_basis;
  for (Eigen::Index j = 0; j < 2; ++j)
    EXPECT_LT(std::abs(pairs(j, 1 - j)) + std::abs(pairs(j, 3 - j)), 1e-14L * pairs.cwiseAbs().maxCoeff());
}

TEST(ModalForm, DiagonalMatricesStayThroughCriticalDamping) {
  Matrix2d k = Eigen::Vector2d(4, 9).asDiagonal(), c = Eigen::Vector2d(4, 0).asDiagonal();
  expect_similar(k, c);
  EXPECT_TRUE(modal_form(k, c)->basis.isDiagonal(0));
  EXPECT_EQ(modal_form(k, c)->growth, 0);
}

TEST(ModalForm, RefusesDependentEigenvectors) {
  // One oscillator drives another one of equal frequency: a Jordan block.
  Matrix2d k;
  k << 4, 0, 1, 4;
  EXPECT_FALSE(modal_form(k, 0.1 * Matrix2d::Identity()));
  k(1, 1) = 4 + 1e-7;
  EXPECT_FALSE(modal_form(k, 0.1 * Matrix2d::Identity()));
}

TEST(ModalForm, KnowsGrowth) {
  EXPECT_NEAR(modal_form(Matrix2d::Identity(), -0.1 * Matrix2d::Identity())->growth, 0.1, 1e-12);
  Matrix2d follower;  // circulatory forces: flutter
  follower << 1, 0.5, -0.5, 1;
  EXPECT_GT(modal_form(follower, Matrix2d::Zero())->growth, 0.1);
}

/// Compares with the generator itself, and with the sampled flow.
TEST(ModalForm, RatesAndBoundsOfRows) {
  Matrix2d k, c;
  k << 5e4, -4e4, -6e5, 7e5;
  c << 10, -3, -60, 80;
  const auto form = modal_form(k, c);
  ASSERT_TRUE(form);
  const MatrixXd a = generator_of(k, c);
  Eigen::RowVectorXd physical(4);
  physical << 1, -0.5, 0.01, 0.02;
  const Eigen::RowVectorXd row = physical * form->basis;
  const Eigen::RowVectorXd rate = physical * a * form->basis;
  EXPECT_LT((rate_of_row(*form, row) - rate).cwiseAbs().maxCoeff(), 1e-9 * rate.cwiseAbs().maxCoeff());

  constexpr double horizon = 0.02;
  const Eigen::RowVectorXd bound = bound_of_row(*form, row, horizon);
  const Eigen::Vector4d z(0.3, -0.2, 0.1, 0.4);
  const double limit = bound(0) * std::hypot(z(0), z(2)) + bound(1) * std::hypot(z(1), z(3));
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    const Eigen::VectorXd moved = matrix_flow(a, horizon * i / 2000) * (form->basis * z);
    largest = std::max(largest, std::abs(physical.dot(moved.transpose())));
  }
  EXPECT_LE(largest, limit * (1 + 1e-12));
  EXPECT_GT(largest, 0.3 * limit);
}

}  // namespace
}  // namespace rubsweep::numerics
