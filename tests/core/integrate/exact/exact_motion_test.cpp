#include "rubsweep/core/integrate/exact/exact_motion.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// Checks all modes of one stop, with unbalance and an active kick, for fixed and dynamic sizes.
template <int N>
void expect_casing_of_the_state() {
  const scene::Scene scene = test::cell_of({}).scene;
  auto modes = std::make_shared<modes::MachineModes<N>>(scene);
  const auto& casing = modes->system().casings.front();
  const run::StateScale seconds = run::state_scale(scene).in_seconds();
  run::PulseTimes pulses(scene, seconds, scene.period_s());
  pulses.begin_turn(0);
  ASSERT_FALSE(pulses.acting().empty());
  typename ExactMotion<N>::State start(8);
  start << 0.2, 1.1, 0.01, 0.05, 3, -20, 1, 7;
  for (std::size_t joint = 0; joint < 4; ++joint) {
    ExactMotion<N> motion(scene, modes);
    motion.set_phases(0.4, pulses, 1e-4);
    ASSERT_TRUE(motion.enter(joint, start));
    motion.step_by_table(6);
    const Eigen::VectorXd state = motion.physical();
    const auto seen = motion.casing(0, motion.here());
    EXPECT_TRUE(seen.displacement.isApprox(casing.map * state.head(4), 1e-14)) << joint;
    EXPECT_TRUE(seen.velocity.isApprox(casing.map * state.tail(4), 1e-14)) << joint;
    EXPECT_GT(seen.velocity.norm(), 0.1);
  }
}

TEST(ExactMotion, SeesACasingAsTheWholeStateHasIt) {
  expect_casing_of_the_state<4>();
  expect_casing_of_the_state<Eigen::Dynamic>();
}

}  // namespace
}  // namespace rubsweep::integrate::exact
