#include "rubsweep/config/dataset/read_candidates.hpp"

#include <gtest/gtest.h>

#include "config/dataset/parsed.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Cause;
using diagnose::Unknown;

std::string read(const std::string& text, std::vector<diagnose::Candidate>& candidates,
                 bool of_any_rotor = true) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    if (const auto value = section.require("candidates", "a list"))
      candidates = read_candidates(*value, of_any_rotor);
  });
}

TEST(ReadCandidates, WordHasTheUsualRangesAndMapItsOwn) {
  std::vector<diagnose::Candidate> candidates;
  ASSERT_EQ(read("candidates:\n  - no_rub\n  - {kind: one_side, name: pin, restitution: 0.8,\n"
                 "     clearance_m: [1.0e-4, 2.0e-4], stiffness_n_per_m: [1.0e6, 1.0e7]}\n",
                 candidates),
            "none");
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].cause, Cause::no_rub);
  EXPECT_EQ(candidates[1].name, "pin");
  EXPECT_EQ(spread_of(candidates[1], Unknown::restitution).low, 0.8);
  EXPECT_EQ(candidates[1].clearance_m.high, 2e-4);
  EXPECT_TRUE(spread_of(candidates[1], Unknown::stiffness).logarithmic);
  EXPECT_EQ(spread_of(candidates[1], Unknown::kick_ratio).high,
            spread_of(diagnose::usual_candidate(Cause::one_side), Unknown::kick_ratio).high);
}

TEST(ReadCandidates, RefusesPlacesAlongTheShaftOfAJeffcottRotor) {
  std::vector<diagnose::Candidate> candidates;
  const std::string text = "candidates: [{kind: one_side, position_m: 0.2}, no_rub]\n";
  EXPECT_EQ(read(text, candidates), "none");
  EXPECT_EQ(candidates[0].position_m->low, 0.2);
  EXPECT_NE(read(text, candidates, false).find("candidates.0.position_m: unknown key"), std::string::npos);
  EXPECT_EQ(read("candidates: [{kind: one_side, position_m: 0}, annular]\n", candidates), "none");
  EXPECT_EQ(candidates[0].position_m->high, 0) << "the very end of the shaft is a place";
  EXPECT_FALSE(candidates[1].position_m);
}

TEST(ReadCandidates, RefusesNumbersThatTheStopsDoNotHave) {
  std::vector<diagnose::Candidate> candidates;
  EXPECT_NE(read("candidates: [{kind: one_side, offset_ratio: 0.5}]\n", candidates).find("offset_ratio"),
            std::string::npos);
  EXPECT_NE(read("candidates: [{kind: no_rub, clearance_m: 1.0e-4}]\n", candidates).find("clearance_m"),
            std::string::npos);
  EXPECT_NE(read("candidates: [{kind: one_side, kick_angle_deg: 0}]\n", candidates).find("kick_angle_deg"),
            std::string::npos);
}

TEST(ReadCandidates, RefusesUnknownWordsAndNamesThatAreTwiceThere) {
  std::vector<diagnose::Candidate> candidates;
  // One problem, and no second one by a candidate that stands in for it.
  const std::string misspelt = read("candidates: [no_rub, one_sid, one_sid]\n", candidates);
  EXPECT_NE(misspelt.find("did you mean 'one_side'?"), std::string::npos);
  EXPECT_EQ(misspelt.find("as another candidate"), std::string::npos) << misspelt;
  EXPECT_NE(read("candidates: [annular, annular]\n", candidates).find("has the name 'annular'"),
            std::string::npos);
  EXPECT_NE(read("candidates: [{name: x}]\n", candidates).find("kind"), std::string::npos);
  EXPECT_NE(read("candidates: []\n", candidates), "none");
}

TEST(ReadCandidates, RefusesNamesThatAreNoCellOfATable) {
  std::vector<diagnose::Candidate> candidates;
  for (const char* name : {"\"a\\nb\"", "\"a\\tb\""})
    EXPECT_NE(read("candidates: [{kind: one_side, name: " + std::string(name) + "}]\n", candidates)
                  .find("candidates.0.name: is no name, allowed: one line of text"),
              std::string::npos)
        << name;
  for (const char* name : {"=1+1", "+1", "-1", "@SUM(A1)"})  // formulas to programs for tables
    EXPECT_NE(read("candidates: [{kind: one_side, name: '" + std::string(name) + "'}]\n", candidates)
                  .find("allowed: one line of text that does not begin with = + - @"),
              std::string::npos)
        << name;
  EXPECT_NE(read("candidates: [{kind: one_side, name: \"\"}]\n", candidates).find("candidates.0.name: "),
            std::string::npos);
  EXPECT_EQ(read("candidates: [{kind: one_side, name: 'a pin, of steel'}]\n", candidates), "none");
}

}  // namespace
}  // namespace rubsweep::config::dataset
