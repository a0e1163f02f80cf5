#include "rubsweep/dataset/recording_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "rubsweep/recording/delimited_text.hpp"
#include "rubsweep/recording/matlab_file.hpp"

namespace rubsweep::dataset {
namespace {

LabelledRecording recording_of(bool plane) {
  LabelledRecording recording{
      .t_s = {0, 1e-3, 2e-3}, .x_m = {1.2345678e-4, -2e-5, 0}, .keyphasor_v = {-2, -12, -2}};
  if (plane) recording.y_m = {1e-6, 2e-6, -3e-6};
  return recording;
}

void expect_same(const recording::Channels& read, const LabelledRecording& written, double relative) {
  const std::size_t columns = written.y_m.empty() ? 3 : 4;
  ASSERT_EQ(read.channels.size(), columns);
  EXPECT_EQ(read.channels[0].name, "t_s");
  EXPECT_EQ(read.channels[0].unit, "s");
  EXPECT_EQ(read.channels[1].unit, "m");
  EXPECT_EQ(read.channels.back().name, "keyphasor_v");
  for (std::size_t k = 0; k < written.t_s.size(); ++k) {
    EXPECT_NEAR(read.channels[1].values[k], written.x_m[k], relative * std::abs(written.x_m[k]));
    EXPECT_EQ(read.channels.back().values[k], written.keyphasor_v[k]);
    if (columns == 4) {
      EXPECT_EQ(read.channels[2].values[k], written.y_m[k]);
    }
  }
}

TEST(RecordingText, IsReadAsARecording) {
  for (const bool plane : {true, false}) {
    const LabelledRecording written = recording_of(plane);
    expect_same(recording::read_delimited_text(recording_csv(written), "recording.csv"), written, 1e-6);
  }
}

TEST(RecordingText, MatlabFileHoldsTheNumbersAsTheyAre) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "recording_text_test.mat";
  for (const bool plane : {true, false}) {
    const LabelledRecording written = recording_of(plane);
    write_recording_matlab(written, file);
    expect_same(recording::read_matlab_file(file), written, 0);
  }
  std::filesystem::remove(file);
}

TEST(RecordingText, RefusesADirectoryThatIsNotThere) {
  EXPECT_ANY_THROW(write_recording_matlab(recording_of(true), "/nowhere/recording.mat"));
}

}  // namespace
}  // namespace rubsweep::dataset
