#include "rubsweep/measurement/diagnosis/diagnose_recording.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>

#include "measurement/diagnosis/machine_file.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnosis {
namespace {

const recording::Instrument two_probes{
    .probes = {{.column = "x", .angle_deg = 30}, {.column = "y", .angle_deg = 120}}};

/// A recording of a circular motion of 20 um at 1X.
recording::Recording circle(int turns, double speed_hz = 60) {
  recording::Recording recording;
  recording.sampling_rate_hz = 6000;
  recording.plane = true;
  for (int turn = 0; turn <= turns; ++turn) recording.turn_begin_s.push_back(turn / speed_hz);
  for (int k = 0; k < turns * recording::samples_per_revolution; ++k)
    recording.displacement_m.push_back(
        std::polar(2e-5, 2 * std::numbers::pi * k / recording::samples_per_revolution));
  return recording;
}

RecordedProblem recorded(recording::Recording recording, const DiagnosisQuestions& questions) {
  return recorded_problem(read_diagnosed_machine(questions.machine, questions.seed), std::move(recording),
                          two_probes, questions);
}

std::string refused(recording::Recording recording, const DiagnosisQuestions& questions) {
  try {
    recorded(std::move(recording), questions);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(DiagnoseRecording, TheProblemIsThatOfRecordingAndMachine) {
  const MachineFile file;
  const RecordedProblem problem = recorded(circle(40), {.name = "run.csv", .machine = file.path, .seed = 7});
  EXPECT_EQ(problem.problem.turns, most_turns);
  EXPECT_EQ(problem.problem.measuring.probes, 2);
  EXPECT_NEAR(problem.problem.measuring.readings_per_turn, 100, 1e-9);
  EXPECT_NEAR(problem.problem.measuring.probe_angle_rad, std::numbers::pi / 6, 1e-15);
  EXPECT_NEAR(problem.problem.speed_hz, 60, 0.003 * 60);
  EXPECT_EQ(problem.problem.seed, 7u);
  for (const diagnose::Candidate& candidate : problem.problem.candidates)
    EXPECT_NEAR(spread_of(candidate, diagnose::Unknown::natural_frequency).low, 30 / 1.01, 1e-12);
}

TEST(DiagnoseRecording, ShortRecordingsAndOnesOfAChangingSpeedAreRefused) {
  const MachineFile file;
  const DiagnosisQuestions questions{.name = "run.csv", .machine = file.path};
  EXPECT_EQ(refused(circle(11), questions), "run.csv: has 11 whole turns, allowed: 12 or more");
  recording::Recording faster = circle(40);
  for (std::size_t k = 0; k < faster.turn_begin_s.size(); ++k)
    faster.turn_begin_s[k] /= 1 + 0.01 * static_cast<double>(k);
  EXPECT_NE(refused(faster, questions).find("run.csv: the speed changes"), std::string::npos);
}

TEST(DiagnoseRecording, PlacesAlongAShaftAreThoseOfAKit) {
  const MachineFile file;
  DiagnosisQuestions questions{.name = "run.csv", .machine = file.path, .list = "candidates.yaml"};
  questions.candidates.candidates[1].position_m = diagnose::Spread{0.1, 0.2};
  EXPECT_NE(refused(circle(20), questions).find("is said of a Jeffcott rotor, allowed: none"),
            std::string::npos);
  const MachineFile of_kit(kit);
  questions.machine = of_kit.path;
  questions.candidates.candidates[1].position_m = diagnose::Spread{0.1, 0.5};
  EXPECT_NE(refused(circle(20), questions).find("is beyond the shaft, allowed: 0 to 0.4"), std::string::npos);
}

TEST(DiagnoseRecording, AStoppedDiagnosisHasNoAnswerWithoutMotions) {
  const MachineFile file;
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(diagnose_recording(circle(20), two_probes, {.name = "run.csv", .machine = file.path},
                                  {.motions = 5, .stop = &stop}));
}

TEST(DiagnoseRecording, ACircleIsNoRubAndKeptMotionsGiveTheSameAnswer) {
  const MachineFile file;
  DiagnosisQuestions questions{.name = "run.csv", .machine = file.path};
  questions.candidates.candidates.resize(2);
  questions.candidates.prior = {0.5, 0.5};
  DiagnosisEffort effort{.motions = 25, .threads = 1, .kept_motions = file.temporary.path() / "kept"};
  std::filesystem::create_directory(effort.kept_motions);
  const RecordedProblem problem = recorded(circle(20), questions);
  EXPECT_FALSE(kept_motions(problem, effort));
  const auto first = diagnose_recording(circle(20), two_probes, questions, effort);
  EXPECT_TRUE(kept_motions(problem, effort));
  effort.threads = 2;
  const auto second = diagnose_recording(circle(20), two_probes, questions, effort);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->candidates.front().name, "no_rub");
  ASSERT_EQ(first->candidates.size(), second->candidates.size());
  for (std::size_t k = 0; k < first->candidates.size(); ++k)
    EXPECT_EQ(first->candidates[k].probability, second->candidates[k].probability);
}

TEST(DiagnoseRecording, ARoundMeansMoreMotions) {
  const MachineFile file;
  DiagnosisQuestions questions{.name = "run.csv", .machine = file.path};
  questions.candidates.candidates.resize(1);
  questions.candidates.prior = {1};
  DiagnosisEffort effort{.motions = 5, .rounds = 1, .kept_motions = file.temporary.path() / "kept"};
  const RecordedProblem problem = recorded(circle(20), questions);
  EXPECT_GE(simulated_motions(problem, effort).cases.size(), 165U);
  effort.rounds = 0;
  EXPECT_FALSE(kept_motions(problem, effort));
  effort.motions = 165;
  EXPECT_TRUE(kept_motions(problem, effort));
}

/// Probability of no rub against one flat stop, for a circle with a small free vibration that no rub caused.
double probability_of_no_rub(double share, double free_vibration_of_cases) {
  const MachineFile file;
  constexpr double speed_hz = 82, order = 30.1 / speed_hz;
  recording::Recording recording = circle(30, speed_hz);
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double turns = static_cast<double>(k) / recording::samples_per_revolution;
    recording.displacement_m[k] +=
        std::polar(share * 2e-5 * std::exp(-0.02 * turns), 2 * std::numbers::pi * order * turns);
  }
  DiagnosisQuestions questions{.name = "run.csv", .machine = file.path};
  questions.candidates.candidates.resize(2);
  questions.candidates.prior = {0.5, 0.5};
  questions.candidates.measuring.free_vibration = free_vibration_of_cases;
  const auto answer = diagnose_recording(std::move(recording), two_probes, questions, {.motions = 400});
  for (const diagnose::answer::CandidateAnswer& candidate : answer->candidates)
    if (candidate.name == "no_rub") return candidate.probability;
  return 0;
}

TEST(DiagnoseRecording, ASmallFreeVibrationIsNoRub) {
  const double expected = probability_of_no_rub(5e-3, 0.01), unexpected = probability_of_no_rub(5e-3, 0);
  EXPECT_GT(expected, 0.7);
  EXPECT_GT(expected / (1 - expected), 3 * unexpected / (1 - unexpected));
  // A vibration of 10 % is larger than what is left of a start.
  EXPECT_LT(probability_of_no_rub(0.1, 0.01), 0.3);
}

/// Answer to a run-up of circles from 42 to 64 Hz whose radius is `radius_m(speed)`: no rub or one flat stop.
diagnose::answer::Answer answer_to_run_up(const std::function<double(double)>& radius_m) {
  const MachineFile file;
  constexpr int turns = 300;
  constexpr double rate = 1.4e-3, first_hz = 42;
  recording::Recording recording{.sampling_rate_hz = 6000, .turn_begin_s = {0}, .plane = true};
  const auto speed_hz = [&](double turn) { return first_hz * std::exp(rate * turn); };
  for (int turn = 0; turn < turns; ++turn)
    recording.turn_begin_s.push_back(recording.turn_begin_s.back() + 1 / speed_hz(turn));
  for (int k = 0; k < turns * recording::samples_per_revolution; ++k) {
    const double turn = static_cast<double>(k) / recording::samples_per_revolution;
    recording.displacement_m.push_back(std::polar(radius_m(speed_hz(turn)), 2 * std::numbers::pi * turn));
  }
  DiagnosisQuestions questions{.name = "run.csv", .machine = file.path};
  questions.candidates.candidates.resize(2);
  questions.candidates.prior = {0.5, 0.5};
  return diagnose_recording(std::move(recording), two_probes, questions, {.motions = 200}).value();
}

TEST(DiagnoseRecording, ARunUpIsNoRubWhereItsSizeFollowsTheResonance) {
  // The whirl of an unbalance above the natural frequency of 30 Hz, and one that grows with the speed
  // instead.
  const auto unbalance = [](double hz) { return 2e-5 / (1 - std::pow(30 / hz, 2)); };
  const auto growing = [](double hz) { return 2e-5 * std::pow(hz / 50, 4); };
  const diagnose::answer::Answer usual = answer_to_run_up(unbalance);
  EXPECT_EQ(usual.candidates.front().name, "no_rub");
  EXPECT_GT(usual.candidates.front().probability, 0.8);
  EXPECT_TRUE(std::ranges::any_of(usual.recording.findings, [](const std::string& finding) {
    return finding.starts_with("the speed changes: stretches of 20 turns at ");
  }));
  EXPECT_GT(answer_to_run_up(growing).none, 3 * usual.none);
}

}  // namespace
}  // namespace rubsweep::diagnosis
