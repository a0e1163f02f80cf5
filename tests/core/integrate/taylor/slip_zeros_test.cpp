#include "rubsweep/core/integrate/taylor/slip_zeros.hpp"

#include <gtest/gtest.h>

#include "core/integrate/law/pressed.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Slip;
using test::Pressed;

/// Zeros of the slip after the contact's forward slip has become zero.
SlipZeros stopped(Pressed& pressed) {
  pressed.law.slips()[0] = Slip::forward;
  SlipZeros zeros(1);
  zeros.stop(pressed.law, 0, pressed.state, pressed.rate, 0);
  return zeros;
}

TEST(SlipZeros, AStoppedContactThatSlipsOnStartsFromOneZero) {
  // A spring force of 1.1 exceeds the friction of 1: it keeps slipping, and only the value of the slip is
  // zero.
  Pressed pressed(1.1, -0.3);
  SlipZeros zeros = stopped(pressed);
  EXPECT_EQ(pressed.law.slips()[0], Slip::backward);
  EXPECT_EQ(zeros.terms(), std::vector<int>{1});
  zeros.clear();
  EXPECT_EQ(zeros.terms(), std::vector<int>{0});
}

TEST(SlipZeros, AStoppedContactThatSticksHasNoRootToPass) {
  Pressed pressed(0.9, -0.3);
  const SlipZeros zeros = stopped(pressed);
  EXPECT_EQ(pressed.law.slips()[0], Slip::sticking);
  EXPECT_EQ(zeros.terms(), std::vector<int>{0});
}

TEST(SlipZeros, AContactThatIsLetGoStartsFromTwoZeros) {
  // Friction is at its limit: the slip and its rate are both zero.
  Pressed pressed(1, -0.3);
  pressed.law.slips()[0] = Slip::sticking;
  SlipZeros zeros(1);
  zeros.let_go(pressed.law, 0, Slip::backward, pressed.state, pressed.rate, 0);
  EXPECT_EQ(pressed.law.slips()[0], Slip::backward);
  EXPECT_EQ(zeros.terms(), std::vector<int>{2});
  pressed.law(pressed.state, pressed.rate, 0);
  EXPECT_NEAR(pressed.law.slip(0, pressed.state), 0, 1e-15);
  EXPECT_NEAR(pressed.law.slip_rate(0, pressed.state, pressed.rate), 0, 1e-15);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
