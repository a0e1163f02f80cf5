#include "rubsweep/core/integrate/exact/joint_switch.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

using contact::Mode;
using State = Eigen::Matrix<double, 8, 1>;

/// A rotor of parameter set A at the wall; surface speed `surface`, closing speed `closing` clearances per
/// second.
struct AtTheWall {
  scene::Scene scene;
  std::shared_ptr<modes::MachineModes<4>> machine;
  ExactMotion<4> motion;
  SlipWatch<4> watch;
  State here = State::Zero();

  AtTheWall(double surface_m_per_s, double closing)
      : scene(with_surface(surface_m_per_s)),
        machine(std::make_shared<modes::MachineModes<4>>(scene)),
        motion(scene, machine),
        watch(scene, machine->friction()) {
    here(1) = 1;
    here(5) = closing;
    motion.set_phases(0);
  }
  static scene::Scene with_surface(double speed_m_per_s) {
    scene::Scene scene = test::cell_of({}).scene;
    scene.pulses.clear();
    scene.contacts[0].surface_speed_m_per_s = speed_m_per_s;
    return scene;
  }
  std::size_t behind(std::size_t joint, std::size_t guard) {
    EXPECT_TRUE(motion.enter(joint, here));
    return joint_mode_behind(motion, watch, guard, here);
  }
};

const std::size_t backward = modes::backward_in_joint_mode(0, 1);

TEST(JointSwitchModeBehind, AHitIsClampedAndItsSlipGoesAsItDoesThere) {
  EXPECT_EQ(AtTheWall(5, 100).behind(0, 0), modes::in_joint_mode(Mode::clamped, 0));
  EXPECT_EQ(AtTheWall(-5, 100).behind(0, 0), modes::in_joint_mode(Mode::clamped, 0) + backward);
}

/// The surface moves forward, but the contact began with a backward slip: the mode keeps the direction
/// backward.
TEST(JointSwitchModeBehind, AContactThatStaysKeepsTheWayOfItsSlip) {
  AtTheWall wall(5, 0);
  wall.here(1) = 1.01;
  EXPECT_EQ(wall.behind(modes::in_joint_mode(Mode::clamped, 0) + backward, 0),
            modes::in_joint_mode(Mode::sprung, 0) + backward);
  EXPECT_EQ(wall.behind(modes::in_joint_mode(Mode::clamped, 0), 0), modes::in_joint_mode(Mode::sprung, 0));
}

TEST(JointSwitchModeBehind, AContactThatEndsLeavesNothing) {
  AtTheWall wall(-5, -100);
  const std::size_t joint = modes::in_joint_mode(Mode::released, 0) + backward;
  ASSERT_TRUE(wall.motion.enter(joint, wall.here));
  ASSERT_EQ(wall.motion.mode().guards[0].next, Mode::open);
  EXPECT_EQ(wall.behind(joint, 0), 0u);
}

}  // namespace
}  // namespace rubsweep::integrate::exact
