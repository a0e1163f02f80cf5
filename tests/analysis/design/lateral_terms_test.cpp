#include "rubsweep/analysis/design/lateral_terms.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <stdexcept>
#include <string_view>

#include "analysis/design/study_of.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/design_page.hpp"
#include "rubsweep/analysis/design/design_terms.hpp"

namespace rubsweep::design {
namespace {

DesignQuestions questions(SpeedRange operating = {50, 160}, double eccentricity_m = 1e-6) {
  return {operating, eccentricity_m, 0, 1, std::vector<Stage>{}};
}

DesignCheck checked(const model::Machine& machine, const DesignQuestions& asked) {
  return check_design(study_of(machine), scene::prepare_machine(machine), asked);
}

/// Words of those checks that have a verdict.
std::set<std::string> with_verdict(const DesignCheck& check, std::string_view verdict) {
  std::set<std::string> found;
  for (const Term& term : terms_of(check)) {
    const bool told = term.not_told.empty() && term.met;
    if ((told ? *term.met ? "ok" : "not_met" : term.not_told.empty() ? "" : "not_told") == verdict)
      found.insert(term.check);
  }
  return found;
}

void expect_only(const DesignCheck& check, const std::string& broken) {
  EXPECT_EQ(answer_of(check), Answer::not_met) << broken;
  EXPECT_EQ(with_verdict(check, "not_met"), std::set{broken}) << design_page(check);
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

/// Rounding of a response has peaks, too.
TEST(LateralTerms, AProbeAtANodeOfTheResponseSeesNoResonance) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  const model::Disc disc{
      .position_m = 0.1, .mass_kg = 0.8, .polar_inertia_kg_m2 = 4e-4, .diametral_inertia_kg_m2 = 2e-4};
  kit.discs = {disc, disc};
  kit.discs[1].position_m = 0.3;
  int of_mode_1 = 0;
  for (const Term& term : checked(machine, questions({60, 160})).lateral) {
    EXPECT_FALSE(term.check == "separation" && term.place == "mode 2 at probe 0") << *term.speed_hz;
    of_mode_1 += term.check == "separation" && term.place == "mode 1 at probe 0";
  }
  EXPECT_GE(of_mode_1, 1);
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

/// In passing its resonance the rotor fills the clearance.
TEST(LateralTerms, AClearanceMayBeTooSmallBelowTheOperatingRangeAlone) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].clearance_m = 1.5e-4;
  expect_only(checked(machine, questions()), "clearance");
}

TEST(LateralTerms, FrictionBreaksTheMarginAgainstDryWhipAlone) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{};
  machine.stops[0].casing.reset();
  machine.stops[0].friction = model::NoFriction{};
  EXPECT_EQ(answer_of(checked(machine, questions())), Answer::pass);
  machine.stops[0].friction = model::ConstantFriction{0.3};
  expect_only(checked(machine, questions()), "dry_whip");
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

Term term_of(const DesignCheck& check, const std::string& word) {
  for (const Term& term : terms_of(check))
    if (term.check == word) return term;
  throw std::out_of_range(word);
}

TEST(LateralTerms, ABearingHasTheTagOfItsFileBesideItsNumber) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->from_file = true;
  model::kit_of(machine)->supports[0].name = "BearingElement_Drive end, \"A\"";
  const DesignCheck check = checked(machine, questions({60, 100}));
  EXPECT_EQ(term_of(check, "bearing_force").name, "Drive end, \"A\"");
  EXPECT_NE(design_page(check).find("bearing force, support 0 (Drive end, \"A\") at "), std::string::npos);
  EXPECT_EQ(term_of(check, "bearing_force").place, "support 0");
}

TEST(LateralTerms, AProbeHasTheNamesOfItsSensors) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->sensors = {{.position_m = 0.2, .name = "mid x"},
                                     {.position_m = 0.2, .angle_deg = 90, .name = "mid y"}};
  const DesignCheck check = checked(machine, questions({60, 100}));
  EXPECT_EQ(term_of(check, "response").name, "mid x, mid y");
  EXPECT_NE(design_page(check).find("  probe 0 (mid x, mid y) at 0.2 m: "), std::string::npos);
  EXPECT_EQ(term_of(check, "vibration").name, "mid x, mid y");
  EXPECT_EQ(term_of(check, "vibration").place, "probe 0");
}

/// The threshold is told with the region, in which Level II is asked for below ten times the coupling.
TEST(LateralTerms, TheRegionOfLevelOneFollowsFromDensityAndRigidBearings) {
  DesignQuestions asked = questions();
  asked.stages = {{false, 1, 1, 1, 1}};
  for (const Term& term : checked(scene::one_side_machine(), asked).lateral)
    EXPECT_NE(term.check, "level_1_region") << "nobody asks";
  asked.gas_density_kg_per_m3 = 40;
  const Term region = term_of(checked(scene::one_side_machine(), asked), "level_1_region");
  EXPECT_NEAR(region.value.value(), 160.0 / 30, 1e-12);
  EXPECT_NEAR(region.limit.value(), 2.23, 1e-12);
  EXPECT_EQ(region.name, "region B");
  EXPECT_FALSE(region.met) << "no verdict, as Level II is computed in any case";
  asked.operating = {31, 60};
  EXPECT_EQ(term_of(checked(scene::one_side_machine(), asked), "level_1_region").name, "region A");
}

TEST(LateralTerms, ADecrementThatIsNotToldHasAReason) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0.6;
  DesignQuestions asked = questions();
  asked.stages = {{false, 1, 1, 1, 1}};
  const DesignCheck check = checked(machine, asked);
  for (const char* word : {"level_1", "level_1_threshold", "level_2"}) {
    EXPECT_FALSE(term_of(check, word).not_told.empty()) << word;
    EXPECT_FALSE(term_of(check, word).met) << word;
  }
  EXPECT_EQ(answer_of(check), Answer::not_told);
}

/// Level II decides, so that an untold Level I alone leaves the answer.
TEST(LateralTerms, LevelOneAsksForNothing) {
  DesignCheck check = checked(scene::one_side_machine(), questions());
  ASSERT_EQ(answer_of(check), Answer::pass);
  check.lateral.push_back({"level_1", ""});
  check.lateral.back().not_told = "no forward whirl";
  EXPECT_EQ(answer_of(check), Answer::pass);
}

/// Damping that turns with the shaft makes the whirl grow above 143 Hz, the speed w0 (1 + 0.02 / ratio).
TEST(LateralTerms, GrowthAboveTheHighestSpeedTakesTheVerdictsThere) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).rotating_damping_ratio = 0.02 / (143.0 / 30 - 1);
  const DesignCheck check = checked(machine, questions({60, 140}));
  EXPECT_EQ(check.growth.growth_per_s, 0);
  EXPECT_EQ(check.whole_growth.growth_per_s, 0);
  EXPECT_GT(check.growth_beyond.growth_per_s, 0);
  ASSERT_TRUE(check.decays_to_hz);
  EXPECT_LT(*check.decays_to_hz, 143);
  EXPECT_GE(*check.decays_to_hz, 140);
  EXPECT_EQ(term_of(check, "clearance_to_trip").not_told, grows_beyond);
  EXPECT_NE(design_page(check).find(" one grows, by up to "), std::string::npos);
  EXPECT_FALSE(checked(machine, questions({50, 110})).decays_to_hz) << "137.5 Hz is all that is looked at";
}

}  // namespace
}  // namespace rubsweep::design
