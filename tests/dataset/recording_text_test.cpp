#include "rubsweep/dataset/recording_text.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <numbers>

#include "batch/temporary_directory.hpp"
#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/error.hpp"
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

TEST(RecordingText, TimesOfALongRecordingAtAHighRateAreThose) {
  LabelledRecording written;
  for (int k = 500000; k < 500100; ++k) {
    written.t_s.push_back(k / 51200.0);
    written.x_m.push_back(1e-4);
    written.keyphasor_v.push_back(-2);
  }
  const recording::Channels read = recording::read_delimited_text(recording_csv(written), "recording.csv");
  for (std::size_t k = 0; k < written.t_s.size(); ++k)
    EXPECT_NEAR(read.channels[0].values[k], written.t_s[k], 1e-6 / 51200);
}

TEST(RecordingText, MatlabFileHoldsTheNumbersAsTheyAre) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "recording.mat";
  for (const bool plane : {true, false}) {
    const LabelledRecording written = recording_of(plane);
    write_recording_matlab(written, file);
    expect_same(recording::read_matlab_file(batch::read_input(file), "recording.mat"), written, 0);
  }
}

TEST(RecordingText, RefusesADirectoryThatIsNotThere) {
  EXPECT_THROW(write_recording_matlab(recording_of(true), "/nowhere/recording.mat"), IoError);
}

/// Files that may not grow beyond so many bytes, as on a full disk, while it lives.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : on_large_file_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, on_large_file_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*on_large_file_)(int);
};

TEST(RecordingText, MatlabFileThatDoesNotFitOnTheDiskIsRefusedAndLeavesNothing) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "recording.mat";
  LabelledRecording recording;
  for (int k = 0; k < 5000; ++k) {
    recording.t_s.push_back(1e-4 * k);
    recording.x_m.push_back(1e-4 * std::sin(std::numbers::e * k));
    recording.keyphasor_v.push_back(-2);
  }
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{100}, rlim_t{5000}, rlim_t{20000}}) {
    const SmallFiles small(bytes);
    EXPECT_THROW(write_recording_matlab(recording, file), IoError) << bytes;
    EXPECT_TRUE(std::filesystem::is_empty(directory.path())) << bytes;
  }
  write_recording_matlab(recording, file);
  EXPECT_GT(std::filesystem::file_size(file), 20000u);
}

}  // namespace
}  // namespace rubsweep::dataset
