#include "rubsweep/response/rotating/cycle_flows.hpp"

#include <gtest/gtest.h>

#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

/// One after the other from one state: each as good as it says, whatever was asked for before.
TEST(CycleFlows, AreAsGoodAsTheySay) {
  auto scene = test::annular_scene(1, 0.02, 1.4, 0.05, 0, 40, 0.3);
  scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  scene.displacement_m(0) = 1.2 * scene.length_scale_m;
  const integrate::run::SolverOptions solver;
  const RotatingField field(scene, solver);
  const CycleFlows flows(scene, solver, 16);
  const RotatingMotion motion = flows.motion(field);
  const Eigen::VectorXd start{{1.2, 0.1, 0.2, -0.6}};
  const double angle_rad = 9;
  const auto best = RotatingFlow(scene, solver, 0).with(1e-12, 0).from(start, angle_rad);
  ASSERT_TRUE(best);
  EXPECT_GT(best->contact_fraction, 0.1);
  const auto off = [&](const std::optional<RotatingArc>& arc) {
    return arc ? (arc->end - best->end).cwiseAbs().maxCoeff() : 1;
  };
  const auto derivative_off = [&](const std::optional<RotatingArc>& arc) {
    return (arc->transition - best->transition).cwiseAbs().maxCoeff() /
           best->transition.cwiseAbs().maxCoeff();
  };
  for (int round = 0; round < 2; ++round) {
    const auto exact = motion.exactly(start, angle_rad), rough = motion.roughly(start, angle_rad),
               first = motion.at_first(start, angle_rad);
    EXPECT_LT(off(exact), 1e-12);
    EXPECT_LT(off(rough), 1e-6);
    EXPECT_LT(off(first), 1e-4);
    EXPECT_GT(off(first), off(exact));
    EXPECT_LT(derivative_off(exact), 1e-9);
    EXPECT_LT(derivative_off(rough), 1e-5);
    EXPECT_LT(derivative_off(first), 1e-3);
    EXPECT_EQ(exact->samples.cols(), 23);
    EXPECT_EQ(rough->samples.cols(), 0);
    const auto end = motion.end(start, angle_rad);
    ASSERT_TRUE(end);
    EXPECT_LT((*end - best->end).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace rubsweep::response::rotating
