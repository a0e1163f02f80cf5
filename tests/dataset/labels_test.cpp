#include "rubsweep/dataset/labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dataset/small_study.hpp"

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
  EXPECT_EQ(cell(line, "file"), std::string(recording.part) + "/000002.csv");
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

}  // namespace
}  // namespace rubsweep::dataset
