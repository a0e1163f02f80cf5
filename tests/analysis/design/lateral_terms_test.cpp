#include "rubsweep/analysis/design/lateral_terms.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "analysis/design/study_of.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/design_tables.hpp"

namespace rubsweep::design {
namespace {

DesignQuestions questions(SpeedRange operating = {50, 160}, double eccentricity_m = 1e-6) {
  return {operating, eccentricity_m, 0, 1, std::vector<Stage>{}};
}

DesignCheck checked(const model::Machine& machine, const DesignQuestions& asked) {
  return check_design(study_of(machine), scene::prepare_machine(machine), asked);
}

/// Words of those checks in the table that have a verdict.
std::set<std::string> with_verdict(const DesignCheck& check, const std::string& verdict) {
  std::set<std::string> found;
  const std::string text = tables_of(check).design_check_csv;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (line.ends_with("," + verdict)) found.insert(line.substr(0, line.find(',')));
    begin = end + 1;
  }
  return found;
}

void expect_only(const DesignCheck& check, const std::string& broken) {
  EXPECT_EQ(answer_of(check), Answer::not_met) << broken;
  EXPECT_EQ(with_verdict(check, "not_met"), std::set{broken}) << tables_of(check).design_check_csv;
}

TEST(LateralTerms, AMachineThatKeepsAllLimitsPasses) {
  const DesignCheck check = checked(scene::one_side_machine(), questions());
  EXPECT_EQ(answer_of(check), Answer::pass) << design_page(check);
  EXPECT_TRUE(design_page(check).starts_with("answer    pass\n")) << design_page(check);
}

TEST(LateralTerms, AResonanceTooNearBreaksTheSeparationAlone) {
  const DesignCheck check = checked(scene::one_side_machine(), questions({33, 160}));
  expect_only(check, "separation");
  EXPECT_TRUE(design_page(check).starts_with("answer    NOT MET: 1 of ")) << design_page(check);
}

TEST(LateralTerms, LittleDampingBreaksTheDecrementAlone) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0.01;
  expect_only(checked(machine, questions()), "level_2");
}

TEST(LateralTerms, PowerBreaksTheDecrementOfADampedRotor) {
  DesignQuestions asked = questions();
  const double w = 2 * std::numbers::pi * 30, zeta = 0.02, threshold = 2 * zeta * 0.8 * w * w;
  // With half of the coupling at which the vibration begins to grow, half of the decrement remains.
  asked.stages = {{false, 0.5 * threshold * 2 * std::numbers::pi * 160 / 3, 1, 1, 1}};
  const DesignCheck check = checked(scene::one_side_machine(), asked);
  expect_only(check, "level_2");
  for (const Term& term : check.lateral) {
    if (term.check == "level_1_threshold") {
      EXPECT_NEAR(term.value.value(), 2, 1e-9);
    }
    if (term.check == "level_1") {
      EXPECT_NEAR(term.value.value(), std::numbers::pi * zeta, 1e-4);
    }
  }
}

TEST(LateralTerms, VibrationBreaksItsLimitAlone) {
  expect_only(checked(scene::one_side_machine(), questions({50, 160}, 1e-5)), "vibration");
}

/// Below the resonance the vibration still grows from the operating range up to trip speed.
TEST(LateralTerms, AClearanceMayBeTooSmallAtTripSpeedAlone) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].clearance_m = 1.05e-5;
  expect_only(checked(machine, questions({10, 22})), "clearance_to_trip");
}

TEST(LateralTerms, WhatTablesDoNotReachAndStagesThatAreNotSaidAreNotTold) {
  const DesignCheck check = checked(scene::table_machine(), {{50, 110}, {}, 0, 1});
  const std::set<std::string> not_told = with_verdict(check, "not_told");
  EXPECT_TRUE(not_told.contains("cross_coupling"));
  EXPECT_TRUE(not_told.contains("separation")) << "tables end below 125 %";
  EXPECT_NE(answer_of(check), Answer::pass);
  EXPECT_NE(design_page(check).find("tables of supports end at"), std::string::npos);
}

TEST(LateralTerms, ResponsesOfModesHaveTheirOwnLinesAtTheProbes) {
  model::Machine machine = scene::light_shaft_machine();
  const DesignCheck check = checked(machine, questions({60, 100}));
  std::set<std::string> places;
  for (const Term& term : check.lateral) places.insert(term.check + " " + term.place);
  EXPECT_TRUE(places.contains("response mode 1 at probe 0"));
  EXPECT_TRUE(places.contains("separation configured at probe 0"));
  EXPECT_TRUE(places.contains("bearing_force support 0"));
}

}  // namespace
}  // namespace rubsweep::design
