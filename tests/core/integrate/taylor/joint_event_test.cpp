#include "rubsweep/core/integrate/taylor/joint_event.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;

/// A free mass before two walls, in units of clearances and radians.
struct Flight {
  scene::Scene scene = two_walls();
  run::ScaledSystem<2> system = run::scale<2>(scene);
  law::Dynamics<2, false> dynamics{system, 0};
  Expansion<2> motion{system};
  run::PulseTimes pulses{scene, run::state_scale(scene), 2 * std::numbers::pi};

  static scene::Scene two_walls() {
    auto scene = test::one_mass_scene(1, 0, 0, 2 * std::numbers::pi, 1);
    for (const double clearance_m : {1.0, 0.7}) {
      scene.contacts.push_back(test::wall_across_x(1, clearance_m, 10, 0));
      scene.contacts.back().friction = model::ConstantFriction{0.2};
    }
    return scene;
  }

  JointEvent after(const std::vector<double>& state, double duration_rad) {
    motion.expand(state.data(), 0, pulses, dynamics.modes(), dynamics.slips());
    return first_event(motion, dynamics, {0, 0}, duration_rad);
  }
};

TEST(JointEvent, TheNearerOfTwoWallsComesFirst) {
  Flight flight;
  const JointEvent event = flight.after({0, 0, 1, 0}, 2);
  EXPECT_NEAR(2 * event.share, 0.7, 1e-14);
  EXPECT_EQ(event.contact, 1u);
  EXPECT_EQ(event.next, Mode::sprung);
  EXPECT_FALSE(event.slip);
}

TEST(JointEvent, NoneWithinADurationThatIsTooShort) {
  Flight flight;
  const JointEvent event = flight.after({0, 0, 1, 0}, 0.5);
  EXPECT_EQ(event.share, 1);
  EXPECT_FALSE(event.contact);
}

TEST(JointEvent, ASlipThatComesToZeroBeforeTheNextWall) {
  // The penetration of the near wall is 0.2; the other wall is 0.1 away, and the spring keeps the mass from
  // it.
  Flight flight;
  flight.dynamics.modes() = {Mode::open, Mode::sprung};
  flight.dynamics.slips() = {contact::Slip::forward, contact::Slip::forward};
  const JointEvent event = flight.after({0.9, 0, 0, 0.1}, 0.4);
  // y' = 0.1 - 0.2 x 10 x 0.2 sin(w t) / w with w^2 = 10.
  const double w = std::sqrt(10.0);
  EXPECT_NEAR(0.4 * event.share, std::asin(0.1 * w / 0.4) / w, 1e-14);
  EXPECT_EQ(event.contact, 1u);
  EXPECT_EQ(event.slip, contact::Slip::sticking);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
