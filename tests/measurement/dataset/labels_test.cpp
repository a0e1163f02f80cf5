#include "rubsweep/measurement/dataset/labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measurement/dataset/small_study.hpp"

namespace rubsweep::dataset {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) c == ',' ? cells.emplace_back() : cells.back() += c;
  return cells;
}

std::string cell(const std::string& line, const std::string& column) {
  const auto names = cells_of(label_header());
  const auto place = std::ranges::find(names, column) - names.begin();
  return cells_of(line).at(static_cast<std::size_t>(place));
}

TEST(Labels, HaveACellForEveryColumn) {
  response::motion::Workspace workspace;
  for (std::size_t index = 0; index < 4; ++index) {
    const LabelledRecording recording = make_recording(small_study(), index, workspace);
    EXPECT_EQ(cells_of(label_line(small_study(), recording)).size(), label_columns().size());
  }
}

TEST(Labels, SayWhatTheRecordingIs) {
  response::motion::Workspace workspace;
  const LabelledRecording recording = make_recording(small_study(), 2, workspace);
  const std::string line = label_line(small_study(), recording);
  EXPECT_EQ(cell(line, "recording"), "2");
  EXPECT_EQ(cell(line, "machine"), "1");
  EXPECT_EQ(cell(line, "cause"), "one_side");
  EXPECT_EQ(cell(line, "rubs"), recording.motion.rubs ? "1" : "0");
  EXPECT_DOUBLE_EQ(std::stod(cell(line, "clearance_m")), recording.clearance_m);
  EXPECT_EQ(std::stod(cell(line, "contact_radius_m")), small_study().fixed.contact_radius_m);
  EXPECT_EQ(std::stod(cell(line, "casing_damping_ratio")), small_study().fixed.casing_damping_ratio);
  EXPECT_EQ(cell(line, "file"), std::string(recording.part) + "/000002.csv");
}

TEST(Labels, KickIsThatOfTheDrawnMachineTurnedWithItsStop) {
  LabelledRecording recording;
  recording.candidate = 1;
  recording.gain = {1, 1};
  recording.stop_angle_deg = 300;
  recording.values[static_cast<std::size_t>(diagnose::Unknown::kick_ratio)] = 3;
  recording.values[static_cast<std::size_t>(diagnose::Unknown::kick_angle)] = 90;
  recording.values[static_cast<std::size_t>(diagnose::Unknown::kick_phase)] = 45;
  recording.motion.kicked = true;
  const std::string kicked = label_line(small_study(), recording);
  EXPECT_EQ(std::stod(cell(kicked, "kick_ratio")), 3);
  EXPECT_DOUBLE_EQ(std::stod(cell(kicked, "kick_angle_deg")), 30);
  EXPECT_EQ(std::stod(cell(kicked, "kick_phase_deg")), 45);
  recording.motion.kicked = false;
  for (const char* column : {"kick_ratio", "kick_angle_deg", "kick_phase_deg"})
    EXPECT_EQ(cell(label_line(small_study(), recording), column), "") << column;
}

TEST(Labels, MarkComesToTheKeyphasorWhenTheLabelSays) {
  response::motion::Workspace workspace;
  DataStudy study = small_study();
  study.measurement.sampling_rate_hz = 1e5;
  const LabelledRecording recording = make_recording(study, 0, workspace);
  const double mark_deg = std::stod(cell(label_line(study, recording), "mark_deg"));
  for (std::size_t k = 1; k < recording.t_s.size(); ++k) {
    if (recording.keyphasor_v[k] != mark_v || recording.keyphasor_v[k - 1] != no_mark_v) continue;
    const double turn_deg = 360 * recording.speed_hz * recording.t_s[k];
    const double per_reading_deg = 360 * recording.speed_hz / 1e5;
    const double late_deg = std::fmod(turn_deg - mark_deg + 360, 360);
    EXPECT_LE(late_deg, per_reading_deg * (1 + 1e-6));
  }
}

TEST(Labels, LeaveEmptyWhatAMachineDoesNotHave) {
  response::motion::Workspace workspace;
  const std::string none = label_line(small_study(), make_recording(small_study(), 0, workspace)),
                    flat = label_line(small_study(), make_recording(small_study(), 2, workspace));
  for (const char* column : {"clearance_m", "stiffness_n_per_m", "whirl_ratio", "stop_angle_deg", "order"})
    EXPECT_EQ(cell(none, column), "") << column;
  for (const char* column : {"offset_ratio", "second_clearance_ratio"})
    EXPECT_EQ(cell(flat, column), "") << column;
}

TEST(Labels, StudyTextTellsStudiesApartButNotDirectories) {
  const DataStudy study = small_study();
  DataStudy other = study;
  other.directory = "elsewhere";
  EXPECT_EQ(study_text(other), study_text(study));
  other.seed = 2;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  spread_of(other.candidates[1], diagnose::Unknown::restitution).high = 0.9;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  other.measurement.gain_error = 0;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  other.candidates[1].name = "pin";
  EXPECT_NE(study_text(other), study_text(study));
}

}  // namespace
}  // namespace rubsweep::dataset
