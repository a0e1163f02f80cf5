#include "rubsweep/maps/sweep/robustness.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

using response::motion::MotionClass;

Row row(MotionClass motion_class, std::optional<int> order = {}) {
  Row row;
  row.motion_class = motion_class;
  row.order = order;
  return row;
}

model::Machine kicked() {
  model::Machine machine;
  machine.kick = model::Kick{.force_n = 200, .duration_s = 0.005, .angle_deg = {}};
  return machine;
}

TEST(RobustnessIsRobust, KicksALittleWeakerAndALittleStronger) {
  std::vector<double> forces_n;
  EXPECT_EQ(is_robust(row(MotionClass::subharmonic, 2), kicked(),
                      [&](const model::Machine& machine) {
                        forces_n.push_back(machine.kick->force_n);
                        return row(MotionClass::subharmonic, 2);
                      }),
            true);
  EXPECT_EQ(forces_n, (std::vector{200 * (1 - 1e-6), 200 * (1 + 1e-6)}));
}

TEST(RobustnessRobustShare, CountsTheNeighboursThatKeepClassAndOrder) {
  const Row found = row(MotionClass::subharmonic, 2);
  std::vector<double> forces_n;
  const auto share =
      robust_share(found, kicked(), {.count = 4, .part = 0.1}, [&](const model::Machine& machine) {
        forces_n.push_back(machine.kick->force_n);
        return machine.kick->force_n > 215 ? row(MotionClass::subharmonic, 3) : found;
      });
  EXPECT_EQ(share, 0.75);
  ASSERT_EQ(forces_n.size(), 4u);
  const std::vector<double> wanted{180, 190, 210, 220};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(forces_n[i], wanted[i], 1e-12);
  EXPECT_FALSE(
      robust_share(row(MotionClass::failed), kicked(), {}, [](const model::Machine&) { return Row{}; }));
}

TEST(RobustnessIsRobust, NotWhereEitherChangesClassOrOrder) {
  const Row found = row(MotionClass::subharmonic, 2);
  for (const Row& other :
       {row(MotionClass::subharmonic, 3), row(MotionClass::non_contact), row(MotionClass::failed)}) {
    for (const bool weaker : {true, false}) {
      EXPECT_EQ(is_robust(found, kicked(),
                          [&](const model::Machine& machine) {
                            return (machine.kick->force_n < 200) == weaker ? other : found;
                          }),
                false);
    }
  }
}

TEST(RobustnessIsRobust, SaysNothingWhereNoKickWasSimulated) {
  const auto never = [](const model::Machine&) -> Row {
    ADD_FAILURE() << "nothing to run";
    return {};
  };
  EXPECT_EQ(is_robust(row(MotionClass::initial_contact), kicked(), never), std::nullopt);
  Row unkicked = row(MotionClass::synchronous, 1);
  unkicked.start = RunStart::contact;
  EXPECT_EQ(is_robust(unkicked, kicked(), never), std::nullopt);
  EXPECT_EQ(is_robust(row(MotionClass::failed), kicked(), never), std::nullopt);
  EXPECT_EQ(is_robust(row(MotionClass::non_contact), model::Machine{}, never), std::nullopt);
}

std::optional<bool> robust(Study study) {
  study.robustness = Robustness::on;
  response::motion::Workspace workspace;
  return evaluate_cell(study, 0, workspace).robust;
}

TEST(RobustnessEvaluateCell, SaysWhetherItIsRobustWhenAsked) {
  // A motion that is at rest after a few turns, one in the middle of the 1/2 tongue, and one without a kick.
  EXPECT_EQ(robust(one_side_study({50}, {0.1})), true);
  EXPECT_EQ(robust(one_side_study({75}, {0.4})), true);
  EXPECT_EQ(robust(one_side_study({75}, {1.2})), std::nullopt);
  response::motion::Workspace workspace;
  EXPECT_EQ(evaluate_cell(one_side_study({50}, {0.1}), 0, workspace).robust, std::nullopt)
      << "off by default";
}

TEST(RobustnessEvaluateCell, TheVerdictIsThatOfTheKickAsItIs) {
  Study study = one_side_study({75}, {0.4});
  response::motion::Workspace workspace;
  Row plain = evaluate_cell(study, 0, workspace);
  study.robustness = Robustness::on;
  const Row asked = evaluate_cell(study, 0, workspace);
  plain.robust = asked.robust;
  EXPECT_EQ(report::map_line(asked), report::map_line(plain));
}

}  // namespace
}  // namespace rubsweep::sweep
