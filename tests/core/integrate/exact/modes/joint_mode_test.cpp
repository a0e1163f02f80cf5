#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using contact::Mode;

/// One mass between walls at x = 1 and x = -0.5, with K = 1e4 N/m and d = 100 N s/m.
struct BetweenWalls {
  scene::Scene scene = test::one_mass_scene(1, 400, 0, 1, 1);
  BetweenWalls() {
    scene.contacts.push_back(test::wall_across_x(1, 1, 1e4, 100));
    scene.contacts.push_back(test::wall_across_x(-1, 0.5, 1e4, 100));
  }
  std::size_t joint(double x, double velocity) const {
    const auto system = run::scale<Eigen::Dynamic>(scene);
    return joint_mode_of(system.contacts, Eigen::Vector4d(x, 0, velocity, 0),
                         Eigen::Vector4d(velocity, 0, -400 * x, 0));
  }
};

TEST(JointMode, HoldsTheModesOfAllContacts) {
  const BetweenWalls walls;
  EXPECT_EQ(walls.joint(0.2, 3), 0u);
  EXPECT_EQ(walls.joint(1.1, 0), in_joint_mode(Mode::sprung, 0));
  EXPECT_EQ(walls.joint(1.1, 1e3), in_joint_mode(Mode::clamped, 0));
  EXPECT_EQ(walls.joint(1.1, -1e3), in_joint_mode(Mode::released, 0));
  EXPECT_EQ(walls.joint(-0.6, 0), in_joint_mode(Mode::sprung, 1));
}

TEST(JointMode, OfGivenModes) {
  const std::vector<Mode> modes{Mode::open, Mode::released, Mode::sprung};
  const std::size_t joint = joint_mode_of(modes);
  for (std::size_t i = 0; i < modes.size(); ++i) EXPECT_EQ(mode_in_joint_mode(joint, i), modes[i]);
  EXPECT_EQ(modes_of_joint_mode(joint, modes.size()), joint);
}

TEST(JointMode, AtTheWallTheDirectionDecides) {
  const BetweenWalls walls;
  EXPECT_EQ(walls.joint(1, 1), in_joint_mode(Mode::clamped, 0));
  EXPECT_EQ(walls.joint(1, -1), 0u);
}

TEST(JointModeKinematicsOf, IsPenetrationAndItsRates) {
  const BetweenWalls walls;
  const auto system = run::scale<Eigen::Dynamic>(walls.scene);
  const auto k = kinematics_of(system.contacts[1], Eigen::Vector4d(-0.7, 9, -2, 9), -5);
  EXPECT_NEAR(k.penetration, 0.2, 1e-15);
  EXPECT_EQ(k.closing_speed, 2);
  EXPECT_EQ(k.closing_acceleration, -5);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
