#include "rubsweep/maps/sweep/untouched_walls.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <variant>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/report/explain_study.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

std::string why(const Study& study) {
  return why_walls_stay_untouched(study, scene::prepare_machine(study.machine));
}

TEST(UntouchedWalls, AKickThatReachesTheWallIsNoReason) {
  EXPECT_EQ(why(one_side_study({60, 75}, {0.2, 0.4})), "");
}

TEST(UntouchedWalls, WithoutAKickNothingTouches) {
  Study study = one_side_study({60, 75}, {0.2, 0.4});
  study.machine.kick.reset();
  EXPECT_TRUE(why(study).starts_with("no kick: "));
  EXPECT_NE(report::explain_study(study).find(why(study)), std::string::npos);
  // Nothing is said of a given start, nor that a kick is missed.
  study.machine.start = {.rotor = {.y_m = 1e-5}};
  EXPECT_EQ(why(study), "");
  study.machine.start.reset();
  // From a whirl ratio of 1 no kick is needed.
  study.grid.unbalance = {1.2};
  EXPECT_EQ(why(study), "");
}

TEST(UntouchedWalls, AWeakKickIsNamedAndReallyTouchesNothing) {
  Study study = one_side_study({60, 75}, {0.4, 1.2, 0.1});
  study.machine.kick->force_n = 20;
  EXPECT_TRUE(why(study).starts_with("weak kick: 20 N for 0.005 s reach no wall"));
  response::motion::Workspace workspace;
  for (const std::size_t cell : {0U, 1U, 4U, 5U}) {
    EXPECT_FALSE(evaluate_cell(study, cell, workspace).last_contact_revolution) << cell;
  }
  // One cell near enough to the wall, or one speed, is enough to say nothing.
  study.grid.unbalance = {0.1, 0.999};
  EXPECT_EQ(why(study), "");
}

/// A Jeffcott rotor is thrown no farther than v / w by an impulse of m v, so that 2 F T / (pi m w) is the clearance
/// that the whirl leaves.
TEST(UntouchedWalls, TheLeastForceIsThatOfTheImpulse) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick->force_n = 2;
  const auto& rotor = std::get<model::JeffcottRotor>(study.machine.rotor);
  const double w = 2 * std::numbers::pi * rotor.natural_frequency_hz, m = rotor.mass_kg;
  const double left_m = 0.6 * study.machine.stops.front().clearance_m;
  const double impulse_force_n = left_m * std::numbers::pi * m * w / (2 * study.machine.kick->duration_s);
  const auto least = least_kick_force_n(study, scene::prepare_machine(study.machine));
  ASSERT_TRUE(least);
  // The whirl adds to the velocity, too, and damping takes a little: the same within a third.
  EXPECT_GT(*least, impulse_force_n / 1.5);
  EXPECT_LT(*least, impulse_force_n * 1.1);
  study.machine.kick->force_n = *least;
  EXPECT_EQ(why(study), "");
  study.machine.kick->force_n = *least / 1.02;
  EXPECT_NE(why(study), "");
  // Nothing is asked for where the kick is strong enough, or is none.
  study.machine.kick->force_n = 1000;
  EXPECT_FALSE(least_kick_force_n(study, scene::prepare_machine(study.machine)));
  study.machine.kick->force_n = 0;
  EXPECT_FALSE(least_kick_force_n(study, scene::prepare_machine(study.machine)));
}

TEST(UntouchedWalls, FaultyBearingsMayMoveTheRotorAllTheSame) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick.reset();
  study.machine.stops.front().clearance_m = 1e-3;
  scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  prepared.assembly.impulses.push_back(
      {Eigen::VectorXd::Unit(prepared.assembly.system.coordinates(), 1), 1, 0});
  EXPECT_EQ(why_walls_stay_untouched(study, prepared), "");
}

}  // namespace
}  // namespace rubsweep::sweep
