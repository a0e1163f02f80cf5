#include "rubsweep/measurement/dataset/read_candidates.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "measurement/dataset/parsed.hpp"
#include "rubsweep/core/error.hpp"

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
  ASSERT_EQ(
      read("candidates:\n  - no_rub\n  - {kind: one_side, name: pin, restitution: 0.8,\n"
           "     clearance_m: [1.0e-4, 2.0e-4], stiffness_n_per_m: [1.0e6, 1.0e7], exponent: [1, 1.5]}\n",
           candidates),
      "none");
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].cause, Cause::no_rub);
  EXPECT_EQ(candidates[1].name, "pin");
  EXPECT_EQ(spread_of(candidates[1], Unknown::restitution).low, 0.8);
  EXPECT_EQ(candidates[1].clearance_m.high, 2e-4);
  EXPECT_TRUE(spread_of(candidates[1], Unknown::stiffness).logarithmic);
  EXPECT_EQ(spread_of(candidates[1], Unknown::exponent).high, 1.5);
  EXPECT_EQ(spread_of(candidates[0], Unknown::exponent).high, 1);
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
  // One problem only: the default candidate that replaces a faulty one must not cause a second problem.
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
  for (const char* name : {R"("a\nb")", R"("a\tb")"})
    EXPECT_NE(read("candidates: [{kind: one_side, name: " + std::string(name) + "}]\n", candidates)
                  .find("candidates.0.name: is no name, allowed: one line of text"),
              std::string::npos)
        << name;
  for (const char* name : {"=1+1", "+1", "-1", "@SUM(A1)"})  // spreadsheet programs take these for formulas
    EXPECT_NE(read("candidates: [{kind: one_side, name: '" + std::string(name) + "'}]\n", candidates)
                  .find("allowed: one line of text that does not begin with = + - @"),
              std::string::npos)
        << name;
  EXPECT_NE(read("candidates: [{kind: one_side, name: \"\"}]\n", candidates).find("candidates.0.name: "),
            std::string::npos);
  EXPECT_EQ(read("candidates: [{kind: one_side, name: 'a pin, of steel'}]\n", candidates), "none");
}

std::string refused(const std::string& text) {
  try {
    read_candidate_file_text(text, "list.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(ReadCandidates, UsualListHasEveryCause) {
  const CandidateFile usual = usual_candidate_file();
  ASSERT_EQ(usual.candidates.size(), diagnose::all_causes.size());
  for (std::size_t c = 0; c < usual.candidates.size(); ++c) {
    EXPECT_EQ(usual.candidates[c].cause, diagnose::all_causes[c]);
    EXPECT_GT(usual.candidates[c].clearance_m.low, 0);
    EXPECT_GT(usual.candidates[c].clearance_m.high, usual.candidates[c].clearance_m.low);
  }
  // The prior that configs/recordings/candidates.yaml writes down.
  const CandidateFile written = read_candidate_file_text("prior: [12, 2, 2, 1, 1]\n", "list.yaml");
  for (std::size_t c = 0; c < usual.prior.size(); ++c) EXPECT_DOUBLE_EQ(usual.prior[c], written.prior[c]);
}

TEST(ReadCandidates, WhatIsMissingIsUsual) {
  const CandidateFile usual = usual_candidate_file();
  const CandidateFile read = read_candidate_file_text("measurement: {gain_error: 0.05}\n", "list.yaml");
  ASSERT_EQ(read.candidates.size(), usual.candidates.size());
  EXPECT_EQ(read.prior, usual.prior);
  EXPECT_EQ(read.candidates[1].clearance_m.low, usual.candidates[1].clearance_m.low);
  EXPECT_EQ(read.measuring.gain_error, 0.05);
  EXPECT_EQ(read.measuring.noise_share.high, usual.measuring.noise_share.high);
}

TEST(ReadCandidates, NoRubIsTwiceAsLikelyAsTheRubsOfAListWithoutPrior) {
  const CandidateFile read =
      read_candidate_file_text("candidates: [one_side, no_rub, annular, two_sides]\n", "list.yaml");
  EXPECT_EQ(read.prior, (std::vector<double>{1.0 / 9, 6.0 / 9, 1.0 / 9, 1.0 / 9}));
}

TEST(ReadCandidates, ClearanceOfTheFileIsThatOfCandidatesWithoutTheirOwn) {
  const CandidateFile read = read_candidate_file_text(
      "clearance_m: [1.0e-4, 3.0e-4]\n"
      "candidates: [no_rub, one_side, {kind: one_side, name: pin, clearance_m: 5.0e-4}]\n"
      "prior: [1, 2, 5]\n",
      "list.yaml");
  ASSERT_EQ(read.candidates.size(), 3u);
  EXPECT_EQ(read.candidates[1].clearance_m.high, 3e-4);
  EXPECT_EQ(read.candidates[2].clearance_m.low, 5e-4);
  EXPECT_DOUBLE_EQ(read.prior[2], 0.625);
  EXPECT_DOUBLE_EQ(std::accumulate(read.prior.begin(), read.prior.end(), 0.0), 1);
}

TEST(ReadCandidates, UnbalanceAndPlacesAlongTheShaft) {
  EXPECT_FALSE(usual_candidate_file().eccentricity_m);
  const CandidateFile read = read_candidate_file_text(
      "eccentricity_m: [2.0e-5, 4.0e-5]\n"
      "candidates: [no_rub, {kind: one_side, position_m: [0.1, 0.2]}, {kind: annular, position_m: 0.3}]\n",
      "list.yaml");
  ASSERT_TRUE(read.eccentricity_m);
  EXPECT_EQ(read.eccentricity_m->high, 4e-5);
  EXPECT_EQ(read.candidates[1].position_m->high, 0.2);
  EXPECT_EQ(read.candidates[2].position_m->low, 0.3);
  EXPECT_NE(refused("candidates: [{kind: no_rub, position_m: 0.1}, annular]\n").find("unknown key"),
            std::string::npos);
  EXPECT_NE(refused("eccentricity_m: [0, 1.0e-5]\n").find("list.yaml:1:17: eccentricity_m"),
            std::string::npos);
}

TEST(ReadCandidates, RefusesListsThatLeaveNothingToChoose) {
  EXPECT_NE(refused("candidates: [annular]\n").find("candidates: has nothing to choose from"),
            std::string::npos);
  EXPECT_NE(refused("candidates: [no_rub, no_rub]\n"), "none");
}

TEST(ReadCandidates, RefusesSharesThatDoNotBelongToTheCandidates) {
  EXPECT_NE(refused("candidates: [no_rub, annular]\nprior: [1, 0]\n").find("prior: has a share"),
            std::string::npos);
  EXPECT_NE(refused("candidates: [no_rub, annular]\nprior: [1, 1, 1]\n").find("list.yaml:2:8: prior"),
            std::string::npos);
}

TEST(ReadCandidates, RefusesKeysItDoesNotKnowAndThoseThatAreTwiceThere) {
  EXPECT_NE(refused("candidats: [no_rub, annular]\n").find("did you mean 'candidates'?"), std::string::npos);
  EXPECT_NE(refused("clearance_m: 1.0e-4\nclearance_m: 2.0e-4\n").find("list.yaml:2:1: clearance_m"),
            std::string::npos);
  EXPECT_NE(refused("clearance_m: -1.0e-4\n").find("list.yaml:1:14: clearance_m"), std::string::npos);
}

std::string read(const std::string& text, bool logarithmic, diagnose::Spread& spread) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    read_spread(section, "k", model::Range{.low = 0, .high = 10}, logarithmic, spread);
    section.refuse_unknown_keys();
  });
}

TEST(ReadCandidatesReadMeasurementSpreadField, NumberIsKnown) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: 3\n", true, spread), "none");
  EXPECT_EQ(spread.low, 3);
  EXPECT_EQ(spread.high, 3);
}

TEST(ReadCandidatesReadMeasurementSpreadField, ListOfTwoIsAnInterval) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: [1, 4]\n", true, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2);
  EXPECT_EQ(read("k: [1, 4]\n", false, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2.5);
}

TEST(ReadCandidatesReadMeasurementSpreadField, MissingKeyLeavesTheUsualInterval) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("{}\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

TEST(ReadCandidatesReadMeasurementSpreadField, RefusesWhatIsNoIntervalWithItsPlace) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("k: [4, 1]\n", false, spread),
            "study.yaml:1:4: k: begins above its end, allowed: [low, high]");
  EXPECT_NE(read("k: [0, 1]\n", true, spread).find("study.yaml:1:4: k: begins at 0"), std::string::npos);
  EXPECT_NE(read("k: [1, 11]\n", false, spread).find("study.yaml:1:4: k: goes out of range"),
            std::string::npos);
  EXPECT_NE(read("k: 11\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, 2, 3]\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, x]\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

std::string read_whole(const std::string& text, rubsweep::dataset::Measurement& measurement) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    if (const auto value = section.require("measurement", "a map")) measurement = read_measurement(*value);
  });
}

std::string read_known(const std::string& text, diagnose::Measuring& measuring) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    if (const auto value = section.require("measurement", "a map")) read_measuring(*value, measuring);
  });
}

TEST(ReadCandidatesReadMeasurement, OfASetHasLengthRateAndProbes) {
  rubsweep::dataset::Measurement measurement;
  ASSERT_EQ(read_whole("measurement: {turns: 40, sampling_rate_hz: 2000, probes: 1, order_2_share: 0.3}\n",
                       measurement),
            "none");
  EXPECT_EQ(measurement.turns, 40);
  EXPECT_EQ(measurement.sampling_rate_hz, 2000);
  EXPECT_EQ(measurement.probes, 1);
  EXPECT_EQ(measurement.other_lines.order_2, 0.3);
  EXPECT_EQ(measurement.other_lines.order_3, diagnose::OtherLines{}.order_3);
}

TEST(ReadCandidatesReadMeasurement, OfADiagnosisHasDisturbancesAlone) {
  diagnose::Measuring measuring;
  ASSERT_EQ(read_known("measurement: {noise_share: 0.01, backward_1x_share: 0.05, order_2_share: 0.02,\n"
                       "  order_3_share: 0, gain_error: 0.1, free_vibration_share: 0.02}\n",
                       measuring),
            "none");
  EXPECT_EQ(measuring.noise_share.low, 0.01);
  EXPECT_EQ(measuring.noise_share.high, 0.01);
  EXPECT_EQ(measuring.other_lines.backward_1x, 0.05);
  EXPECT_EQ(measuring.other_lines.order_2, 0.02);
  EXPECT_EQ(measuring.other_lines.order_3, 0);
  EXPECT_EQ(measuring.gain_error, 0.1);
  EXPECT_EQ(measuring.free_vibration, 0.02);
  // These keys are refused, because the recording itself provides the numbers.
  for (const char* key : {"turns: 40", "probes: 1", "sampling_rate_hz: 2000"})
    EXPECT_NE(read_known("measurement: {" + std::string(key) + "}\n", measuring), "none") << key;
}

TEST(ReadCandidatesReadMeasurement, RefusesSharesThatAreNone) {
  diagnose::Measuring measuring;
  for (const char* field :
       {"noise_share: 0", "noise_share: [0.1, 2]", "gain_error: -0.1", "order_3_share: 1.5"}) {
    const std::string said = read_known("measurement: {" + std::string(field) + "}\n", measuring);
    EXPECT_NE(said.find("study.yaml:1:"), std::string::npos) << said;
    EXPECT_NE(said.find("measurement."), std::string::npos) << said;
  }
  EXPECT_NE(read_known("measurement: {gain_eror: 0.1}\n", measuring).find("did you mean 'gain_error'?"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::dataset
