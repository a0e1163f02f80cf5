#include "rubsweep/config/dataset/read_candidate_file.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "rubsweep/error.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Cause;
using diagnose::Unknown;

std::string refused(const std::string& text) {
  try {
    read_candidate_file_text(text, "list.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(ReadCandidateFile, UsualListHasEveryCauseAndEqualShares) {
  const CandidateFile usual = usual_candidate_file();
  ASSERT_EQ(usual.candidates.size(), diagnose::all_causes.size());
  for (std::size_t c = 0; c < usual.candidates.size(); ++c) {
    EXPECT_EQ(usual.candidates[c].cause, diagnose::all_causes[c]);
    EXPECT_GT(usual.candidates[c].clearance_m.low, 0);
    EXPECT_GT(usual.candidates[c].clearance_m.high, usual.candidates[c].clearance_m.low);
    EXPECT_DOUBLE_EQ(usual.prior[c], 0.2);
  }
}

TEST(ReadCandidateFile, WhatIsMissingIsUsual) {
  const CandidateFile usual = usual_candidate_file();
  const CandidateFile read = read_candidate_file_text("measurement: {gain_error: 0.05}\n", "list.yaml");
  ASSERT_EQ(read.candidates.size(), usual.candidates.size());
  EXPECT_EQ(read.prior, usual.prior);
  EXPECT_EQ(read.candidates[1].clearance_m.low, usual.candidates[1].clearance_m.low);
  EXPECT_EQ(read.measuring.gain_error, 0.05);
  EXPECT_EQ(read.measuring.noise_share.high, usual.measuring.noise_share.high);
}

TEST(ReadCandidateFile, ClearanceOfTheFileIsThatOfCandidatesWithoutTheirOwn) {
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

TEST(ReadCandidateFile, UnbalanceAndPlacesAlongTheShaft) {
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

TEST(ReadCandidateFile, RefusesListsThatLeaveNothingToChoose) {
  EXPECT_NE(refused("candidates: [annular]\n").find("candidates: has nothing to choose from"),
            std::string::npos);
  EXPECT_NE(refused("candidates: [no_rub, no_rub]\n"), "none");
}

TEST(ReadCandidateFile, RefusesSharesThatDoNotBelongToTheCandidates) {
  EXPECT_NE(refused("candidates: [no_rub, annular]\nprior: [1, 0]\n").find("prior: has a share"),
            std::string::npos);
  EXPECT_NE(refused("candidates: [no_rub, annular]\nprior: [1, 1, 1]\n").find("list.yaml:2:8: prior"),
            std::string::npos);
}

TEST(ReadCandidateFile, RefusesKeysItDoesNotKnowAndThoseThatAreTwiceThere) {
  EXPECT_NE(refused("candidats: [no_rub, annular]\n").find("did you mean 'candidates'?"), std::string::npos);
  EXPECT_NE(refused("clearance_m: 1.0e-4\nclearance_m: 2.0e-4\n").find("list.yaml:2:1: clearance_m"),
            std::string::npos);
  EXPECT_NE(refused("clearance_m: -1.0e-4\n").find("list.yaml:1:14: clearance_m"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::dataset
