#include "rubsweep/core/integrate/exact/tangents_one_by_one.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

using State = modes::ExactTypes<4>::State;

TangentsOneByOne<4> unit_vectors() {
  TangentsOneByOne<4> tangents;
  tangents.resize(8, 8);
  for (Eigen::Index i = 0; i < 8; ++i) tangents.set(static_cast<std::size_t>(i), State::Unit(i));
  return tangents;
}

TEST(TangentsOneByOne, MoveByTheFlowOfTheirMode) {
  modes::MachineModes<4> plan(test::cell_of({}).scene);
  for (const std::size_t joint : {0u, 1u, 2u, 3u}) {
    const modes::LinearMode<4>& mode = *plan.mode(joint);
    TangentsOneByOne<4> tangents = unit_vectors();
    constexpr int step = 9;
    if (mode.paired)
      tangents.move(mode.pair_steps[std::size_t{step}]);
    else
      tangents.move(mode.steps.of(step));
    const double duration_s = mode.longest_step_s * numerics::exact_step_size(step);
    const Eigen::MatrixXd flow =
        mode.inverse * numerics::matrix_flow(mode.generator, duration_s) * mode.basis;
    for (std::size_t i = 0; i < tangents.size(); ++i) {
      const Eigen::VectorXd expected = flow.col(static_cast<Eigen::Index>(i));
      EXPECT_LT((tangents.get(i) - expected).norm(), 1e-12 * flow.norm()) << joint << ' ' << i;
    }
  }
}

/// Product of rows with unit vectors: each sum has one entry per row and vector.
TEST(TangentsOneByOne, AreSeenByALinearFunction) {
  Eigen::Matrix<double, 4, Eigen::Dynamic> rows = Eigen::MatrixXd::Zero(4, 8);
  rows.col(1) << 1, 2, 3, 0;
  rows.col(5) << -4, 5, 6, 0;
  modes::ModalSums sums;
  unit_vectors().see(modes::modal_terms(rows, {true, true, true, true}), false, 10, sums);
  const Eigen::Map<const Eigen::VectorXd> value(sums.value.data(), 8), rate(sums.rate.data(), 8),
      curvature(sums.curvature.data(), 8);
  EXPECT_EQ(value, 10 * rows.row(0).transpose());
  EXPECT_EQ(rate, 10 * rows.row(1).transpose());
  EXPECT_EQ(curvature, 10 * rows.row(2).transpose());
}

}  // namespace
}  // namespace rubsweep::integrate::exact
