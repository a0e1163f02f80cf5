#include "rubsweep/diagnose/answer/overlay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "small_answer.hpp"

namespace rubsweep::diagnose::answer {
namespace {

TEST(Overlay, FindsScaleTurnAndMark) {
  const MotionLines recorded = small_motion();
  MotionLines simulated = recorded;
  for (int k = -simulated.last(); k <= simulated.last(); ++k)
    simulated.at(k) *= std::polar(7.0, 0.4 + k * 2 * 3.14159265358979324 * 11 / 64 / 4);
  const Overlay overlay = lay_over(recorded, simulated, true);
  EXPECT_LT(overlay.unexplained, 1e-12);
  EXPECT_LT((overlay.simulated.amplitude - recorded.amplitude).norm(), 1e-9);
}

TEST(Overlay, LeavesWhatTheOtherMotionDoesNotHave) {
  MotionLines other = small_motion();
  other.at(2) = 0;
  // Energies are 1 and 1/4: a circle of the same size has 1 in common: |c|^2 / (1.25 x 1.25).
  const double common = 1e-4 * std::sqrt(1.25) * 1e-4;
  const double left = 2 * 1.25e-8 - 2 * common;
  EXPECT_NEAR(lay_over(small_motion(), other, true).unexplained, left / 1.25e-8, 1e-9);
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
