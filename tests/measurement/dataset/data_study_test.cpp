#include "rubsweep/measurement/dataset/data_study.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Unknown;

std::string fault(const std::string& text) {
  try {
    read_data_study_text(text, "study.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

const std::string output = "output: {directory: d}\n";

TEST(DataStudyRead, NeedsNoMoreThanADirectory) {
  const auto study = read_data_study_text(output, "study.yaml");
  EXPECT_EQ(study.directory, "d");
  EXPECT_EQ(study.candidates.size(), 5u);
  for (const auto& candidate : study.candidates)
    EXPECT_GT(spread_of(candidate, Unknown::natural_frequency).low, 0) << candidate.name;
}

TEST(DataStudyRead, RangesOfTheMachineAreThoseOfEveryCandidateUnlessItHasItsOwn) {
  const auto study = read_data_study_text(
      output +
          "machine: {mass_kg: 3, natural_frequency_hz: 40, damping_ratio: [0.01, 0.02], clearance_m: "
          "2.0e-4}\n"
          "candidates: [annular, {kind: one_side, clearance_m: 5.0e-4}]\n"
          "recordings: 7\nrecordings_per_machine: 2\nseed: 9\nformat: matlab\n"
          "measurement: {turns: 16, sampling_rate_hz: 1000, probes: 1, noise_share: 0.01}\n"
          "rub: {penetration_ratio: 0.2, force_ratio: 30}\nother_causes_share: 0.25\n",
      "study.yaml");
  EXPECT_EQ(study.rub.penetration_ratio, 0.2);
  EXPECT_EQ(study.rub.force_ratio, 30);
  EXPECT_EQ(study.other_causes_share, 0.25);
  EXPECT_EQ(study.fixed.rotor_mass_kg, 3);
  EXPECT_EQ(study.candidates[0].clearance_m.low, 2e-4);
  EXPECT_EQ(study.candidates[1].clearance_m.low, 5e-4);
  for (const auto& candidate : study.candidates) {
    EXPECT_EQ(spread_of(candidate, Unknown::natural_frequency).high, 40);
    EXPECT_EQ(spread_of(candidate, Unknown::damping_ratio).high, 0.02);
  }
  EXPECT_EQ(study.recordings, 7);
  EXPECT_EQ(study.seed, 9u);
  EXPECT_EQ(study.format, rubsweep::dataset::Format::matlab);
  EXPECT_EQ(study.measurement.probes, 1);
  EXPECT_EQ(study.measurement.turns, 16);
  EXPECT_EQ(study.measurement.noise_share.high, 0.01);
}

TEST(DataStudyRead, RefusesWithPlaceAndWhatIsAllowed) {
  EXPECT_NE(fault("recordings: 5\n").find("output"), std::string::npos);
  EXPECT_NE(fault(output + "recordings: 0\n").find("study.yaml:2:13: recordings: "), std::string::npos);
  EXPECT_NE(fault(output + "recording: 5\n").find("did you mean 'recordings'?"), std::string::npos);
  EXPECT_NE(fault(output + "other_causes_share: 1.5\n").find("other_causes_share: 1.5 is out of range"),
            std::string::npos);
  EXPECT_NE(fault(output + "rub: {force_ratio: 0}\n").find("rub.force_ratio: "), std::string::npos);
  EXPECT_NE(fault(output + "measurement: {probes: 3}\n").find("measurement.probes: "), std::string::npos);
  EXPECT_NE(fault(output + "split: {training: 0.5, validation: 0.1, test: 0.1}\n").find("add up to 1"),
            std::string::npos);
  EXPECT_NE(fault(output + "measurement: {sampling_rate_hz: 100}\n").find("fewer than 5 times in a turn"),
            std::string::npos);
  EXPECT_NE(fault(output + "measurement: {sampling_rate_hz: 1.1e6}\n").find("measurement.sampling_rate_hz: "),
            std::string::npos);
  EXPECT_NE(
      fault(output + "machine: {natural_frequency_hz: [0, 30]}\n").find("machine.natural_frequency_hz: "),
      std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::dataset
