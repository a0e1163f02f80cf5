#include "explain/explain_study.hpp"

#include <gtest/gtest.h>

#include <string>

#include "explain/explain_machine.hpp"
#include "maps/report/says.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"

namespace rubsweep::apps {
using report::says;

namespace {

TEST(ExplainStudy, BeginsWithTheSceneAtTheLowestSpeed) {
  const sweep::Study study = sweep::one_side_study({75, 50, 90}, {0.4});
  EXPECT_TRUE(explain_study(study).starts_with(explain_machine(study.machine, 50)));
}

TEST(ExplainStudy, GridWhateverItsOrder) {
  sweep::Study study = sweep::one_side_study({75, 50, 90}, {0.6, 0.1});
  EXPECT_TRUE(
      says(explain_study(study),
           "sweep: 6 cells, 3 speeds from 50 to 90 Hz (3000 to 5400 rpm), 2 whirl ratios from 0.1 to 0.6\n"));
  study.grid.measure = sweep::UnbalanceMeasure::eccentricity_m;
  EXPECT_TRUE(says(explain_study(study), "2 eccentricities from 0.1 to 0.6 m\n"));
}

TEST(ExplainStudy, OneValueIsSaidByItself) {
  sweep::Study study = sweep::one_side_study({75}, {0.4});
  EXPECT_TRUE(says(explain_study(study), "\nsweep: 1 cells, speed 75 Hz (4500 rpm), whirl ratio 0.4\n"));
  study.grid.written_speed = {.key = "speed_rpm", .unit = "rpm", .units_per_si = 60};
  EXPECT_TRUE(says(explain_study(study), "\nsweep: 1 cells, speed 4500 rpm (75 Hz), whirl ratio 0.4\n"));
}

TEST(ExplainStudy, SolverAndHowACellEnds) {
  sweep::Study study = sweep::one_side_study({50}, {0.4});
  EXPECT_TRUE(says(explain_study(study), "solver: exact (auto: wherever it applies), closed forms"));
  EXPECT_TRUE(says(explain_study(study),
                   "turns whose friction is not saturated in\n  Taylor pieces, to rounding, too\n"));
  EXPECT_TRUE(says(explain_study(study), "contact: located"));
  study.solver.stepper = integrate::run::Stepper::dopri5;
  EXPECT_TRUE(
      says(explain_study(study), "turns whose friction is not saturated by the\n  adaptive one: dopri5"));
  EXPECT_TRUE(says(explain_study(study), "relative tolerance 1e-08\n"));
  study.solver.stepper = integrate::run::Stepper::automatic;
  EXPECT_TRUE(says(explain_study(study),
                   "a cell ends when rest or a stable orbit is proven, else after 40 revolutions, by its "
                   "last two windows of 12\n"));
  study.solver.method = integrate::run::Method::adaptive;
  study.solver.contact = integrate::run::ContactHandling::smoothed;
  study.solver.smoothing_m = 2e-7;
  EXPECT_TRUE(says(explain_study(study), "solver: adaptive, dopri5"));
  EXPECT_TRUE(
      says(explain_study(study), "contact: smoothed over 2e-07 m of penetration, no event location\n"));
}

TEST(ExplainStudy, SaysWhichStepperAutoTakesAndWhy) {
  sweep::Study study = sweep::one_side_study({50}, {0.4});
  EXPECT_FALSE(says(explain_study(study), "stepper auto"));
  study.solver.method = integrate::run::Method::adaptive;
  EXPECT_TRUE(says(explain_study(study), "stepper auto: rosenbrock4 (implicit"));
  // The limit is 4 tolerance^(-1/4).
  EXPECT_TRUE(says(explain_study(study), "change the slip 400 times faster than the contact spring"));
  study.solver.relative_tolerance = 1e-4;
  EXPECT_TRUE(says(explain_study(study), "change the slip 40 times faster"));
  study.machine.stops[0].friction = model::ConstantFriction{0.1};
  EXPECT_TRUE(
      says(explain_study(study), "stepper auto: dopri5 throughout, as no friction depends on the slip\n"));
  study.solver.stepper = integrate::run::Stepper::dopri5;
  EXPECT_FALSE(says(explain_study(study), "stepper auto"));
}

TEST(ExplainStudy, NamesEveryStepper) {
  sweep::Study study = sweep::one_side_study({50}, {0.4});
  for (const auto stepper : integrate::adaptive::single_steppers()) {
    study.solver.stepper = stepper;
    EXPECT_TRUE(says(explain_study(study), integrate::adaptive::row_of(stepper).description));
  }
}

}  // namespace
}  // namespace rubsweep::apps
