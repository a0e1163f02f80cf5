#include "rubsweep/measurement/dataset/labelled_recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
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

TEST(LabelledRecording, HasThePeakAccelerationOfItsRotor) {
  response::motion::Workspace workspace;
  const LabelledRecording quiet = make_recording(small_study(), 0, workspace);
  ASSERT_FALSE(quiet.motion.rubs);
  // A circle at the shaft speed, whose radius the whirl of a linear rotor gives.
  const double natural_hz = value_of(quiet.values, Unknown::natural_frequency),
               damping = value_of(quiet.values, Unknown::damping_ratio), ratio = quiet.speed_hz / natural_hz;
  const double radius_m =
      quiet.motion.eccentricity_m * ratio * ratio / std::hypot(1 - ratio * ratio, 2 * damping * ratio);
  const double expected = radius_m * std::pow(2 * std::numbers::pi * quiet.speed_hz, 2);
  EXPECT_NEAR(quiet.peak_acceleration_m_per_s2, expected, 0.01 * expected);
}

TEST(LabelledRecording, AnExponentChangesNoOtherNumberOfItsMachine) {
  DataStudy study = small_study();
  const MachineDraw of_spring = draw_machine(study, 1);
  spread_of(study.candidates[1], Unknown::exponent) = {1, 1.5, false};
  const MachineDraw drawn = draw_machine(study, 1);
  EXPECT_EQ(drawn.unit, of_spring.unit);
  EXPECT_EQ(drawn.gain, of_spring.gain);
  const double exponent = value_of(values_at(study.candidates[1], drawn.unit), Unknown::exponent);
  EXPECT_GT(exponent, 1);
  EXPECT_LT(exponent, 1.5);
  response::motion::Workspace workspace;
  const LabelledRecording recording = make_recording(study, 2, workspace);
  EXPECT_EQ(value_of(recording.values, Unknown::exponent), exponent);
  EXPECT_LE(recording.penetration_ratio, study.rub.penetration_ratio);
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
  // Tolerance: four standard deviations of a binomial distribution.
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

using diagnose::samples_per_revolution;
using std::numbers::pi;

/// A recording of an elliptic motion with a half-order line, 20 turns at 50 Hz.
LabelledRecording ellipse() {
  LabelledRecording recording{.speed_hz = 50, .gain = {1, 1}};
  for (int k = 0; k < 20 * samples_per_revolution; ++k) {
    const double turn = static_cast<double>(k) / samples_per_revolution;
    recording.motion.displacement_m.push_back(2e-4 * std::polar(1.0, 2 * pi * turn) +
                                              1e-4 * std::polar(1.0, -pi * turn));
  }
  return recording;
}

Measurement plain() {
  Measurement measurement;
  measurement.noise_share = {0, 0};
  measurement.other_lines = {0, 0, 0};
  return measurement;
}

/// Order between 0.1 and 0.95 whose forward component of the readings is strongest.
double strongest_slow_order(const LabelledRecording& recording) {
  double best = 0, strongest = 0;
  for (double order = 0.1; order < 0.95; order += 0.005) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
      const double turn = recording.speed_hz * recording.t_s[k],
                   length = recording.speed_hz * recording.t_s.back(),
                   window = 1 - std::cos(2 * pi * turn / length);
      sum +=
          window * std::complex(recording.x_m[k], recording.y_m[k]) * std::polar(1.0, -2 * pi * order * turn);
    }
    if (std::abs(sum) > strongest) {
      strongest = std::abs(sum);
      best = order;
    }
  }
  return best;
}

TEST(LabelledRecording, OtherCausesReplaceQuietWhirlsAlone) {
  DataStudy study = small_study();
  study.measurement = plain();
  study.measurement.turns = 40;
  study.candidates.resize(1);
  const DataStudy quiet = study;
  study.other_causes_share = 0.5;
  response::motion::Workspace workspace;
  int others = 0, oil_whirls = 0;
  for (std::size_t k = 0; k < 120; ++k) {
    const LabelledRecording one = make_recording(study, k, workspace),
                            without = make_recording(quiet, k, workspace);
    EXPECT_EQ(without.other_cause, "");
    EXPECT_EQ(one.other_cause.empty(), one.x_m == without.x_m) << k;
    EXPECT_EQ(one.t_s, without.t_s);
    others += !one.other_cause.empty();
    if (one.other_cause != "oil_whirl") continue;
    ++oil_whirls;
    EXPECT_NEAR(strongest_slow_order(one), 0.44, 0.075) << k;
  }
  EXPECT_NEAR(others, 60, 4 * std::sqrt(30));
  EXPECT_GE(oil_whirls, 3);

  // A rotor that rubs keeps its motion.
  study = small_study();
  study.other_causes_share = 1;
  EXPECT_EQ(make_recording(study, 2, workspace).x_m, make_recording(small_study(), 2, workspace).x_m);
  EXPECT_EQ(make_recording(study, 2, workspace).other_cause, "");
}

TEST(LabelledRecordingReadings, AreTheMotionAtTheirTimes) {
  LabelledRecording recording = ellipse();
  diagnose::RandomStream random(1, 0, 0);
  read_motion(plain(), random, recording);
  ASSERT_EQ(recording.t_s.size(), recording.x_m.size());
  ASSERT_EQ(recording.t_s.size(), recording.y_m.size());
  // 20 turns without their last sample, which belongs to the next turn.
  EXPECT_EQ(recording.t_s.size(), 2000u);
  for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
    const double turn = 50 * recording.t_s[k];
    const auto z = 2e-4 * std::polar(1.0, 2 * pi * turn) + 1e-4 * std::polar(1.0, -pi * turn);
    EXPECT_NEAR(recording.x_m[k], z.real(), 1e-10);
    EXPECT_NEAR(recording.y_m[k], z.imag(), 1e-10);
  }
}

TEST(LabelledRecordingReadings, MarkPassesOnceATurnWhereItStands) {
  // Five readings per turn are the fewest that a study may have.
  for (const double readings_per_turn : {5.0, 7.3, 18.5, 100.0}) {
    for (const double mark_turns : {0.0, 0.25, 0.66, 0.93}) {
      LabelledRecording recording = ellipse();
      diagnose::RandomStream random(1, 0, 0);
      Measurement measurement = plain();
      measurement.sampling_rate_hz = 50 * readings_per_turn;
      recording.mark_turns = mark_turns;
      read_motion(measurement, random, recording);
      int passages = recording.keyphasor_v.front() == mark_v;
      for (std::size_t k = 1; k < recording.t_s.size(); ++k) {
        if (!(recording.keyphasor_v[k] == mark_v && recording.keyphasor_v[k - 1] == no_mark_v)) continue;
        ++passages;
        const double late = 50 * recording.t_s[k] - mark_turns;
        EXPECT_LE(late - std::floor(late), (1 + 1e-9) / readings_per_turn) << mark_turns;
      }
      // One mark per turn up to the last reading; a mark that is passing at the start has no leading edge.
      const int marks = static_cast<int>(std::floor(50 * recording.t_s.back() - mark_turns)) + 1;
      EXPECT_GE(marks, 19);
      EXPECT_EQ(passages, marks + (mark_turns + mark_share > 1)) << readings_per_turn << ' ' << mark_turns;
    }
  }
}

TEST(LabelledRecordingReadings, NoiseAndGainAreThoseThatAreSaid) {
  LabelledRecording recording = ellipse(), clean = ellipse();
  recording.gain = {1.1, 0.9};
  diagnose::RandomStream random(1, 0, 0), same(1, 0, 0);
  Measurement noisy = plain();
  noisy.noise_share = {0.05, 0.05};
  read_motion(noisy, random, recording);
  read_motion(plain(), same, clean);
  // The size of the motion contains both circles.
  EXPECT_NEAR(recording.noise_m, 0.05 * std::hypot(2e-4, 1e-4), 1e-9);
  double squares_x = 0, squares_y = 0;
  const auto count = static_cast<double>(clean.x_m.size());
  for (std::size_t k = 0; k < clean.x_m.size(); ++k) {
    squares_x += std::pow(recording.x_m[k] - 1.1 * clean.x_m[k], 2);
    squares_y += std::pow(recording.y_m[k] - 0.9 * clean.y_m[k], 2);
  }
  // Tolerance: four standard errors of a standard deviation.
  for (const double squares : {squares_x, squares_y})
    EXPECT_NEAR(std::sqrt(squares / count) / recording.noise_m, 1, 4 / std::sqrt(2 * count));
}

TEST(LabelledRecordingReadings, OfOneProbeHaveNoY) {
  LabelledRecording recording = ellipse();
  recording.gain = {1};
  diagnose::RandomStream random(1, 0, 0);
  read_motion(plain(), random, recording);
  EXPECT_FALSE(recording.x_m.empty());
  EXPECT_TRUE(recording.y_m.empty());
}

}  // namespace
}  // namespace rubsweep::dataset
