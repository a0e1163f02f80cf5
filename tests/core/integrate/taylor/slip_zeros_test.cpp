#include "rubsweep/core/integrate/taylor/slip_zeros.hpp"

#include <gtest/gtest.h>

#include "core/integrate/law/pressed.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Slip;
using test::Pressed;

/// Zeros after the forward slip of the contact has come to zero.
SlipZeros stopped(Pressed& pressed) {
  pressed.law.slips()[0] = Slip::forward;
  SlipZeros zeros(1);
  zeros.stop(pressed.law, 0, pressed.state, pressed.rate, 0);
  return zeros;
}

TEST(SlipZeros, AStoppedContactThatSlipsOnStartsFromOneZero) {
  // A spring of 1.1 against friction of 1: it slips on, and of its slip the value alone is zero.
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
  // Friction is at its limit: the slip and its rate are zero.
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
