#include "rubsweep/core/numerics/side_by_side.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "rubsweep/core/numerics/matrix_vector.hpp"

namespace rubsweep::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Vectors given as columns of `rows` numbers and stored as rows.
class Vectors {
 public:
  explicit Vectors(const MatrixXd& columns) : memory_(MatrixXd(columns.transpose())) {}

  SideBySide view() { return {memory_.data(), memory_.stride(), memory_.rows()}; }
  VectorXd get(Index i) const {
    VectorXd vector(memory_.cols());
    for (Index j = 0; j < vector.size(); ++j) vector(j) = memory_.data()[j * memory_.stride() + i];
    return vector;
  }

 private:
  AlignedMatrix memory_;
};

/// Tests with numbers of vectors that leave registers of every width partly empty.
class SideBySideVectors : public testing::TestWithParam<Index> {
 protected:
  Index count() const { return GetParam(); }
};

TEST_P(SideBySideVectors, ProductsHaveTheBitsOfEveryOneAlone) {
  for (Index rows = 1; rows <= 20; ++rows) {
    const Index columns = 1 + (5 * rows) % 13;
    const MatrixXd matrix = MatrixXd::Random(rows, columns), vectors = MatrixXd::Random(columns, count());
    Vectors from(vectors), to(MatrixXd::Zero(rows, count()));
    multiply_each(rows, columns, matrix.data(), matrix.outerStride(), from.view(), to.view());
    for (Index i = 0; i < count(); ++i)
      EXPECT_EQ(to.get(i), product_of<VectorXd>(matrix, VectorXd(vectors.col(i)))) << rows << ' ' << i;
  }
}

TEST_P(SideBySideVectors, AreScaled) {
  const MatrixXd matrix = MatrixXd::Random(5, 5), vectors = MatrixXd::Random(5, count());
  Vectors scaled(vectors);
  scale_each(5, matrix.data(), matrix.outerStride() + 1, scaled.view());
  for (Index i = 0; i < count(); ++i)
    EXPECT_EQ(scaled.get(i), matrix.diagonal().cwiseProduct(vectors.col(i)));
}

TEST_P(SideBySideVectors, PairsMoveByTheirFlows) {
  const Eigen::Array<double, 3, 4> flow = Eigen::Array<double, 3, 4>::Random();
  const MatrixXd vectors = MatrixXd::Random(6, count());
  Vectors moved(vectors);
  move_pairs_of_each(3, flow.data(), moved.view());
  for (Index i = 0; i < count(); ++i) {
    const Eigen::Array3d u = vectors.col(i).head<3>(), v = vectors.col(i).tail<3>();
    VectorXd expected(6);
    expected << flow.col(0) * u + flow.col(1) * v, flow.col(2) * u + flow.col(3) * v;
    EXPECT_EQ(moved.get(i), expected) << i;
  }
}

TEST_P(SideBySideVectors, TermsOfASeriesAreAdded) {
  const auto some = [&](Index rows) -> MatrixXd { return MatrixXd::Random(rows, count()); };
  const MatrixXd springs = some(3), dampers = some(3), vectors = some(6), sums = some(6);
  Vectors spring(springs), damper(dampers), state(vectors), sum(sums);
  add_term_to_each(3, 0.7, spring.view(), damper.view(), state.view(), state.view().from(3), sum.view());
  for (Index i = 0; i < count(); ++i) {
    VectorXd term(6);
    term << 0.7 * vectors.col(i).tail<3>(), -0.7 * (springs.col(i) + dampers.col(i));
    EXPECT_EQ(state.get(i), term) << i;
    EXPECT_EQ(sum.get(i), sums.col(i) + term) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(AnyCount, SideBySideVectors, testing::Values(1, 2, 3, 4, 5, 8, 9, 19));

}  // namespace
}  // namespace rubsweep::numerics
