#include "rubsweep/core/integrate/law/settle_slips.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/integrate/law/pressed.hpp"

namespace rubsweep::integrate::law {
namespace {

using contact::Slip;
using test::Pressed;

TEST(SettleSlips, AStateWithASlipSaysWhichWayItGoes) {
  EXPECT_EQ(Pressed(0, 0).entered(), Slip::forward);
  EXPECT_EQ(Pressed(0, -1).entered(), Slip::backward);
}

TEST(SettleSlips, WhatStandsSticksUntilTheSpringIsStronger) {
  // Friction of up to 0.5 x 100 x 0.02 = 1 acts against a spring force of 0.9.
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
