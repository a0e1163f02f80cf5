#include "rubsweep/integrate/law/settle_slips.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::law {
namespace {

using contact::Mode;
using contact::Slip;

/// Unit mass on a unit spring, pressed on a wall across x by the share `pressed` of its clearance; the wall
/// feels a friction of 0.5. The surface moves at 0.3.
struct Pressed {
  explicit Pressed(double y, double y_rate, double pressed = 0.02)
      : scene(with_wall()), system(run::scale<2>(scene)), law(system, 0), state{1 + pressed, y, 0, y_rate} {
    law.modes()[0] = Mode::sprung;
  }

  static scene::Scene with_wall() {
    auto scene = test::one_mass_scene(1, 1, 0, 2 * std::numbers::pi, 1);
    scene::Contact wall = test::wall_across_x(1, 1, 100, 0);
    wall.friction = model::ConstantFriction{0.5};
    wall.surface_speed_m_per_s = 0.3;
    scene.contacts.push_back(wall);
    return scene;
  }

  Slip entered() {
    enter_slips_by_state(law, state, rate, 0);
    return law.slips()[0];
  }

  scene::Scene scene;
  run::ScaledSystem<2> system;
  Dynamics<2, false> law;
  std::vector<double> state, rate = std::vector<double>(4);
};

TEST(SettleSlips, AStateWithASlipSaysWhichWayItGoes) {
  EXPECT_EQ(Pressed(0, 0).entered(), Slip::forward);
  EXPECT_EQ(Pressed(0, -1).entered(), Slip::backward);
}

TEST(SettleSlips, WhatStandsSticksUntilTheSpringIsStronger) {
  // Friction up to 0.5 x 100 x 0.02 = 1 against a spring of 1.
  Pressed near(0.9, -0.3);
  EXPECT_EQ(near.entered(), Slip::sticking);
  near.law.loose(near.state, near.rate, 0);
  const auto holding = near.law.hold(near.state, near.rate);
  EXPECT_NEAR(near.rate[3], 0, 1e-15);
  EXPECT_NEAR(holding.force_n(0), -0.9, 1e-15);
  // The spring pulls the rotor, and its surface with it, towards -y.
  EXPECT_EQ(Pressed(1.1, -0.3).entered(), Slip::backward);
  EXPECT_EQ(Pressed(-1.1, -0.3).entered(), Slip::forward);
}

TEST(SettleSlips, ChangesLoseTheirSlipWhereAContactBeginsToStick) {
  Pressed pressed(0.4, -0.3);
  pressed.law.slips()[0] = Slip::forward;
  pressed.law(pressed.state, pressed.rate, 0);
  const std::vector<double> before = pressed.rate;
  settle_slips(pressed.law, pressed.state, pressed.rate, 0, [](std::size_t) { return true; });
  ASSERT_EQ(pressed.law.slips()[0], Slip::sticking);
  pressed.law(pressed.state, pressed.rate, 0);
  Eigen::MatrixXd crossed = Eigen::MatrixXd::Identity(4, 4), kept = crossed;
  cross_slip(pressed.law, 0, pressed.state, before, pressed.rate, crossed);
  pressed.law.keep_sticking(pressed.state, kept);
  EXPECT_LT((pressed.law.slip_gradient(0, pressed.state) * crossed).norm(), 1e-15);
  EXPECT_LT((crossed - kept).norm(), 1e-15);
  EXPECT_EQ(crossed.leftCols(3), Eigen::MatrixXd::Identity(4, 4).leftCols(3));
}

}  // namespace
}  // namespace rubsweep::integrate::law
