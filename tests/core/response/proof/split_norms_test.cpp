#include "rubsweep/core/response/proof/split_norms.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "rubsweep/core/numerics/dense/self_adjoint.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Turns of a section of six numbers of which a contact sees the first two: the last two are a vibration of
/// its own, a slow focus, that the others drive; the two in between decay at once.
struct Turns {
  std::vector<MatrixXd> list;
  MatrixXd seen = MatrixXd::Zero(2, 6);

  explicit Turns(double shrinks) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 3; ++k) {
      MatrixXd turn = MatrixXd::Zero(6, 6);
      for (double& x : turn.leftCols(4).reshaped()) x = 0.2 * normal(random);
      const double angle = 0.7 + k;
      turn.bottomRightCorner(2, 2) << std::cos(angle), -3 * std::sin(angle), std::sin(angle) / 3,
          std::cos(angle);
      turn.rightCols(2) *= shrinks;
      list.push_back(turn);
    }
    seen(0, 0) = seen(1, 1) = 1;
  }
};

/// Spectral norm, by the largest eigenvalue of matrix^T matrix.
double largest(const MatrixXd& matrix) {
  return std::sqrt(numerics::dense::self_adjoint_eigenvalues(matrix.transpose() * matrix).maxCoeff());
}

TEST(SplitNorms, AVibrationThatNoContactSeesIsTheSlowPart) {
  const Turns turns(0.98);
  const auto norms = split_norms(turns.list, turns.seen);
  ASSERT_TRUE(norms);
  EXPECT_EQ(norms->fast, 4);
  EXPECT_EQ(norms->slow(), 2);
  EXPECT_NEAR(norms->contraction.slow, std::cbrt((1 + std::pow(0.98, 3)) / 2), 1e-9);
  EXPECT_LT(norms->contraction.fast, 0.9);
  VectorXd offset = VectorXd::Zero(6);
  offset.tail(2) << 0.3, -0.1;
  EXPECT_NEAR(parts_of(*norms, 1, offset).fast, 0, 1e-12);
  EXPECT_GT(parts_of(*norms, 1, offset).slow, 0.1);
}

TEST(SplitNorms, EveryTurnDrawsBothPartsTogether) {
  const Turns turns(0.98);
  const auto norms = split_norms(turns.list, turns.seen);
  ASSERT_TRUE(norms);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE((norms->norm[k] * norms->unit[k] - MatrixXd::Identity(6, 6)).norm(), 1e-10);
    const MatrixXd turn = norms->norm[(k + 1) % 3] * turns.list[k] * norms->unit[k];
    EXPECT_LE(largest(turn.topLeftCorner(4, 4)), norms->contraction.fast * (1 + 1e-9));
    EXPECT_LE(largest(turn.bottomRightCorner(2, 2)), norms->contraction.slow * (1 + 1e-9));
    // Contacts do not see the slow part, and so it drives nothing.
    EXPECT_LE(largest(turn.topRightCorner(4, 2)), 1e-10);
  }
}

TEST(SplitNorms, NoneWhereContactsSeeEverything) {
  const Turns turns(0.98);
  MatrixXd seen = turns.seen;
  seen(0, 4) = 1e-3;
  EXPECT_FALSE(split_norms(turns.list, seen));
}

TEST(SplitNorms, NoneWhereTheUnseenVibrationDecaysAtOnceOrGrows) {
  const Turns fast(0.3), growing(1.01);
  EXPECT_FALSE(split_norms(fast.list, fast.seen));
  EXPECT_FALSE(split_norms(growing.list, growing.seen));
}

/// One wall above: penetration is the rotor's y less the casing's.
TEST(SplitNormsSeenByContacts, PenetrationsAndTheirRates) {
  const MatrixXd rows = seen_by_contacts(test::cell_of({}).scene);
  ASSERT_EQ(rows.rows(), 2);
  ASSERT_EQ(rows.cols(), 8);
  MatrixXd wanted = MatrixXd::Zero(2, 8);
  wanted(0, 1) = wanted(1, 5) = 1;
  wanted(0, 3) = wanted(1, 7) = -1;
  EXPECT_LE((rows - wanted).norm(), 1e-12);
}

}  // namespace
}  // namespace rubsweep::response::proof
