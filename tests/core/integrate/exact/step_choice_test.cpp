#include "rubsweep/core/integrate/exact/step_choice.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

using Motion = ExactMotion<4>;

/// A rotor in flight, `gap` clearances before the wall and approaching it.
struct Approach {
  scene::Scene scene;
  std::shared_ptr<modes::MachineModes<4>> plan;
  Motion motion;

  static scene::Scene unkicked() {
    auto scene = test::cell_of({}).scene;
    scene.pulses.clear();
    return scene;
  }

  explicit Approach(double gap, double speed_per_s)
      : scene(unkicked()), plan(std::make_shared<modes::MachineModes<4>>(scene)), motion(scene, plan) {
    Motion::State start = Motion::State::Zero();
    start(1) = 1 - gap;
    start(5) = speed_per_s;
    motion.set_phases(0);
    motion.enter(0, start);
  }
};

TEST(StepChoiceChoose, FarFromTheWallItIsSafeAllAlong) {
  for (const double gap : {0.9, 0.4, 0.1}) {
    const Approach start(gap, 100);
    const StepChoice choice = choose_step(start.motion, {.until_s = 1, .reach_s = start.motion.reach_s()});
    ASSERT_GT(choice.step_s, 0);
    ASSERT_LE(choice.step_s, start.motion.mode().longest_step_s);
    if (choice.crossing != StepChoice::none) continue;
    for (int i = 1; i <= 100; ++i) {
      Approach moved(gap, 100);
      moved.motion.step_by(choice.step_s * i / 100);
      EXPECT_LT(moved.motion.guard(0).value, 1e-12) << gap << ' ' << i;
    }
  }
}

TEST(StepChoiceChoose, CloseToTheWallItNamesTheCrossingAndWhenAtTheLatest) {
  Approach near(1e-4, 300);
  const StepChoice choice = choose_step(near.motion, {.until_s = 1, .reach_s = near.motion.reach_s()});
  ASSERT_NE(choice.crossing, StepChoice::none);
  const double duration_s = near.motion.land(choice.crossing, choice.step_s);
  EXPECT_LE(duration_s, choice.step_s);
  EXPECT_NEAR(near.motion.guard(0).value, 0, 1e-15);
  EXPECT_GT(near.motion.guard(0).rate, 0);
}

TEST(StepChoiceChoose, NoLandingBeyondReachAndNothingBeyondTheBoundary) {
  const Approach near(1e-4, 300);
  EXPECT_EQ(choose_step(near.motion, {.until_s = 1, .reach_s = 1e-9}).crossing, StepChoice::none);
  const StepChoice cut = choose_step(near.motion, {.until_s = 1e-8, .reach_s = near.motion.reach_s()});
  EXPECT_EQ(cut.step_s, 1e-8);
  EXPECT_EQ(cut.crossing, StepChoice::none);
}

constexpr double instant = 1e-6;

TEST(StepChoice, OfTwoCrossingsTheOneThatIsCertainlyFirst) {
  for (const bool earlier_one_first : {true, false}) {
    StepChoice choice{.step_s = 10};
    for (const bool earlier : {earlier_one_first, !earlier_one_first})
      choice.keep_first(earlier ? 7 : 8, earlier ? 1 : 3, earlier ? 2 : 4, instant);
    EXPECT_EQ(choice.crossing, 7u);
    EXPECT_EQ(choice.step_s, 2);
    EXPECT_EQ(choice.earliest_s, 1);
  }
}

/// The crossing whose latest possible time is earlier may still come second.
TEST(StepChoice, WhereTwoCrossingsOverlapTheStepEndsBeforeEither) {
  for (const bool one_first : {true, false}) {
    StepChoice choice{.step_s = 10};
    for (const bool one : {one_first, !one_first})
      choice.keep_first(one ? 7 : 8, one ? 1 : 1.5, one ? 3 : 2, instant);
    EXPECT_EQ(choice.crossing, StepChoice::none);
    EXPECT_EQ(choice.step_s, 1);
  }
}

TEST(StepChoice, CrossingsAtOneInstantAreLandedOnTogether) {
  StepChoice choice{.step_s = 10};
  choice.keep_first(7, 1, 1 + 0.4 * instant, instant);
  choice.keep_first(8, 1 - 0.2 * instant, 1 + 0.3 * instant, instant);
  EXPECT_EQ(choice.crossing, 8u);
  choice.keep_below(1, instant);
  EXPECT_EQ(choice.crossing, 8u);
}

TEST(StepChoice, ACrossingThatIsGivenUpIsNotSteppedOver) {
  StepChoice choice{.step_s = 10};
  choice.keep_first(7, 1, 3, instant);
  choice.keep_below(4, instant);
  EXPECT_EQ(choice.crossing, 7u);
  choice.keep_below(2, instant);
  EXPECT_EQ(choice.crossing, StepChoice::none);
  EXPECT_EQ(choice.step_s, 1);
}

}  // namespace
}  // namespace rubsweep::integrate::exact
