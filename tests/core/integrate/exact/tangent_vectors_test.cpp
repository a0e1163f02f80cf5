#include "rubsweep/core/integrate/exact/tangent_vectors.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

constexpr run::StateScale scale_of_sections{.length_m = 1e-3, .speed_rad_per_s = 470};

/// Converts a flow to the units of a section, whose velocities are scaled by the speed.
Eigen::MatrixXd as_sections(const Eigen::MatrixXd& flow) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(8);
  scale.tail(4).setConstant(scale_of_sections.speed_rad_per_s);
  return scale.cwiseInverse().asDiagonal() * flow * scale.asDiagonal();
}

/// Tests with sizes known to the compiler, and with dynamic sizes, where many vectors lie side by side.
template <class Size>
class TangentVectorsOf : public testing::Test {};
using Sizes = testing::Types<std::integral_constant<int, 4>, std::integral_constant<int, Eigen::Dynamic>>;
TYPED_TEST_SUITE(TangentVectorsOf, Sizes);

/// A flight, then two contact modes, one of which has no modal form: the result is the product of three
/// matrix exponentials.
TYPED_TEST(TangentVectorsOf, FollowEveryModeByItsFlow) {
  modes::MachineModes<TypeParam::value> plan(test::cell_of({}).scene);
  TangentVectors<TypeParam::value> carried;
  Eigen::MatrixXd disturbances = Eigen::MatrixXd::Identity(8, 8);
  carried.begin(*plan.mode(0), scale_of_sections, disturbances);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Identity(8, 8);
  std::size_t last = 0;
  for (const auto& [joint, duration_s] : {std::pair{0u, 0.011}, {2u, 0.0004}, {3u, 0.0017}}) {
    const modes::LinearMode<TypeParam::value>& mode = *plan.mode(joint);
    if (joint != last) carried.change(*plan.mode(last), mode);
    last = joint;
    carried.pass(0.25 * duration_s);
    carried.pass(0.75 * duration_s);
    expected = numerics::matrix_flow(mode.generator, duration_s) * expected;
  }
  ASSERT_FALSE(plan.mode(3)->paired);
  carried.put(*plan.mode(3), scale_of_sections, disturbances);
  const Eigen::MatrixXd wanted = as_sections(expected);
  EXPECT_LT((disturbances - wanted).cwiseAbs().maxCoeff(), 1e-12 * wanted.cwiseAbs().maxCoeff());
}

TYPED_TEST(TangentVectorsOf, NoneAreCarriedWhereNoneAreAskedFor) {
  modes::MachineModes<TypeParam::value> plan(test::cell_of({}).scene);
  TangentVectors<TypeParam::value> carried;
  Eigen::MatrixXd disturbances = Eigen::MatrixXd::Identity(8, 2);
  carried.begin(*plan.mode(0), scale_of_sections, disturbances);
  carried.clear();
  carried.pass(0.01);
  carried.put(*plan.mode(0), scale_of_sections, disturbances);
  EXPECT_EQ(disturbances, Eigen::MatrixXd(Eigen::MatrixXd::Identity(8, 2)));
}

/// A vector that joins later moves on from there and is not part of the matrix of the first ones.
TYPED_TEST(TangentVectorsOf, OneMayJoinOnTheWay) {
  modes::MachineModes<TypeParam::value> plan(test::cell_of({}).scene);
  for (const std::size_t joint : {0u, 3u}) {
    const modes::LinearMode<TypeParam::value>& mode = *plan.mode(joint);
    TangentVectors<TypeParam::value> carried;
    Eigen::MatrixXd disturbances = Eigen::MatrixXd::Identity(8, 8);
    carried.begin(mode, scale_of_sections, disturbances);
    carried.pass(0.001);
    typename modes::ExactTypes<TypeParam::value>::State joins(8);
    joins << 0.3, -0.2, 0.1, 0.5, 10, -20, 30, 5;
    carried.add(mode, joins);
    carried.pass(0.0005);
    const auto now = carried.now(mode);
    ASSERT_EQ(now.size(), 9);
    const Eigen::VectorXd wanted = numerics::matrix_flow(mode.generator, 0.0005) * joins;
    EXPECT_LT((mode.from_free(now[8]) - wanted).cwiseAbs().maxCoeff(), 1e-11 * wanted.cwiseAbs().maxCoeff());
    carried.put(mode, scale_of_sections, disturbances);
    ASSERT_EQ(disturbances.cols(), 8);
    const Eigen::MatrixXd whole = as_sections(numerics::matrix_flow(mode.generator, 0.0015));
    EXPECT_LT((disturbances - whole).cwiseAbs().maxCoeff(), 1e-11 * whole.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace rubsweep::integrate::exact
