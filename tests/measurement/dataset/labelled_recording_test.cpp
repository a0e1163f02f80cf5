#include "rubsweep/measurement/dataset/labelled_recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "measurement/dataset/small_study.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Unknown;

bool lies_in(double low, double value, double high) { return low <= value && value <= high; }

TEST(LabelledRecording, DependsOnStudyAndIndexAlone) {
  response::motion::Workspace used, fresh;
  make_recording(small_study(), 1, used);
  const LabelledRecording one = make_recording(small_study(), 3, used),
                          same = make_recording(small_study(), 3, fresh);
  EXPECT_EQ(one.x_m, same.x_m);
  EXPECT_EQ(one.y_m, same.y_m);
  EXPECT_EQ(one.values, same.values);
  DataStudy other = small_study();
  other.seed = 2;
  EXPECT_NE(make_recording(other, 3, fresh).x_m, one.x_m);
}

TEST(LabelledRecording, RecordingsOfAMachineShareItsNumbersAndNotTheirOwn) {
  response::motion::Workspace workspace;
  const LabelledRecording a = make_recording(small_study(), 2, workspace),
                          b = make_recording(small_study(), 3, workspace),
                          c = make_recording(small_study(), 4, workspace);
  EXPECT_EQ(a.machine, b.machine);
  EXPECT_NE(a.machine, c.machine);
  for (const Unknown unknown : {Unknown::natural_frequency, Unknown::damping_ratio, Unknown::stiffness})
    EXPECT_EQ(value_of(a.values, unknown), value_of(b.values, unknown));
  EXPECT_NE(value_of(a.values, Unknown::natural_frequency), value_of(c.values, Unknown::natural_frequency));
  EXPECT_EQ(a.clearance_m, b.clearance_m);
  EXPECT_EQ(a.stop_angle_deg, b.stop_angle_deg);
  EXPECT_EQ(a.gain, b.gain);
  EXPECT_EQ(a.part, b.part);
  EXPECT_NE(a.speed_hz, b.speed_hz);
  EXPECT_NE(value_of(a.values, Unknown::whirl_ratio), value_of(b.values, Unknown::whirl_ratio));
}

TEST(LabelledRecording, NumbersStayInTheirRanges) {
  response::motion::Workspace workspace;
  const DataStudy study = small_study();
  for (std::size_t index = 0; index < 6; ++index) {
    const LabelledRecording recording = make_recording(study, index, workspace);
    const double frequency_hz = value_of(recording.values, Unknown::natural_frequency);
    EXPECT_TRUE(lies_in(study.speed_ratio.low, recording.speed_hz / frequency_hz, study.speed_ratio.high));
    EXPECT_TRUE(lies_in(25, frequency_hz, 35));
    EXPECT_TRUE(lies_in(1e-4, recording.clearance_m, 5e-4));
    EXPECT_TRUE(recording.candidate == 1 || !recording.motion.rubs);
  }
}

TEST(LabelledRecording, RubsAreThoseThatAMachineSurvives) {
  response::motion::Workspace workspace;
  DataStudy study = small_study();
  study.candidates = diagnose::usual_candidates();
  for (diagnose::Candidate& candidate : study.candidates) {
    candidate.clearance_m = {5e-5, 1e-3, true};
    spread_of(candidate, Unknown::natural_frequency) = {20, 60, false};
    spread_of(candidate, Unknown::damping_ratio) = {0.01, 0.04, true};
  }
  int rubs = 0, deep_without_bounds = 0;
  for (std::size_t index = 10; index < 30; ++index) {
    study.rub = {};
    const LabelledRecording recording = make_recording(study, index, workspace);
    const double force_n = recording.motion.contact.peak_contact_force_n;
    rubs += recording.motion.rubs;
    EXPECT_LE(force_n, 100 * 9.81 * study.fixed.rotor_mass_kg);
    EXPECT_LE(force_n / value_of(recording.values, Unknown::stiffness), 0.5 * recording.clearance_m);
    EXPECT_EQ(recording.penetration_ratio > 0, recording.motion.rubs);
    study.rub = {.penetration_ratio = 1e9, .force_ratio = 1e9};
    deep_without_bounds += make_recording(study, index, workspace).penetration_ratio > 0.5;
  }
  EXPECT_GE(rubs, 4);
  EXPECT_GE(deep_without_bounds, 2);
}

TEST(LabelledRecording, BoundsThatNoDrawKeepsAreNamed) {
  response::motion::Workspace workspace;
  DataStudy study = small_study();
  spread_of(study.candidates[1], Unknown::whirl_ratio) = {2, 3, false};
  study.rub = {.penetration_ratio = 1e-9, .force_ratio = 1e-9};
  try {
    make_recording(study, 2, workspace);
    FAIL();
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("rub.penetration_ratio"), std::string::npos) << error.what();
  }
}

TEST(LabelledRecording, PartsHoldTheirSharesOfTheMachines) {
  DataStudy study = small_study();
  study.split = {0.5, 0.2, 0.3};
  constexpr std::size_t machines = 4000;
  std::map<std::string_view, int> count;
  for (std::size_t machine = 0; machine < machines; ++machine) ++count[draw_machine(study, machine).part];
  const std::map<std::string_view, double> shares{{"training", 0.5}, {"validation", 0.2}, {"test", 0.3}};
  ASSERT_EQ(count.size(), 3u);
  // Four standard deviations of a binomial distribution.
  for (const auto& [part, share] : shares)
    EXPECT_NEAR(count[part], machines * share, 4 * std::sqrt(machines * share * (1 - share))) << part;
}

TEST(LabelledRecording, WholeShareIsEveryMachine) {
  DataStudy study = small_study();
  for (const auto& [split, part] : {std::pair<Split, std::string_view>{{1, 0, 0}, "training"},
                                    {{0, 1, 0}, "validation"},
                                    {{0, 0, 1}, "test"}}) {
    study.split = split;
    for (std::size_t machine = 0; machine < 100; ++machine)
      EXPECT_EQ(draw_machine(study, machine).part, part);
  }
}

TEST(LabelledRecording, CandidatesTakeTurns) {
  for (std::size_t machine = 0; machine < 6; ++machine)
    EXPECT_EQ(candidate_of(small_study(), machine), machine % 2);
}

TEST(LabelledRecording, ProbesHaveGainsOfTheirOwn) {
  DataStudy study = small_study();
  const MachineDraw both = draw_machine(study, 0);
  ASSERT_EQ(both.gain.size(), 2u);
  EXPECT_NE(both.gain[0], both.gain[1]);
  study.measurement.probes = 1;
  EXPECT_EQ(draw_machine(study, 0).gain.size(), 1u);
}

}  // namespace
}  // namespace rubsweep::dataset
