#include "rubsweep/core/integrate/exact/modes/step_flows.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/numerics/matrix_vector.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

Eigen::MatrixXd some_generator() {
  Eigen::Matrix2d stiffness, damping;
  stiffness << 4, -1, 3, 50;
  damping << 0.1, 0, -0.2, 0.2;
  return numerics::generator_of(stiffness, damping);
}

/// The flow of a step is the same whichever steps were requested before, short or long ones first.
TEST(StepFlows, DoNotDependOnWhatWasAskedForBefore) {
  StepFlows<Eigen::Matrix4d> up(some_generator(), 2), down(some_generator(), 2);
  ASSERT_EQ(up.size(), static_cast<std::size_t>(numerics::exact_step_count));
  for (int k = 0; k < numerics::exact_step_count; ++k) up.of(k);
  for (int k = numerics::exact_step_count; k-- > 0;) {
    EXPECT_EQ(down.of(k), up.of(k)) << k;
    const Eigen::Matrix4d flow = numerics::matrix_flow(some_generator(), 2 * numerics::exact_step_size(k));
    EXPECT_LT((up.of(k) - flow).cwiseAbs().maxCoeff(), 1e-15 * flow.cwiseAbs().maxCoeff()) << k;
  }
}

TEST(StepFlows, AreFactorsOfAnyKind) {
  StepFlows<numerics::AlignedMatrix> aligned(some_generator(), 2);
  StepFlows<Eigen::Matrix4d> plain(some_generator(), 2);
  EXPECT_EQ(aligned.of(5).diagonal(), plain.of(5).diagonal());
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
