#include "rubsweep/measurement/dataset/data_set.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "maps/batch/temporary_directory.hpp"
#include "measurement/dataset/small_study.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"

namespace rubsweep::dataset {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class DataSetTest : public testing::Test {
 protected:
  void SetUp() override { study_.directory = directory_.path() / "recordings"; }

  const TemporaryDirectory directory_;
  DataStudy study_ = small_study();
};

const auto nothing = [] {};

TEST_F(DataSetTest, GoesOnWhereItWasStopped) {
  {
    DataSet set(study_, "rubdata 0");
    std::atomic<bool> stop{false};
    int finished = 0;
    EXPECT_FALSE(set.make(
        set.missing(), 1, [&] { stop = ++finished == 2; }, stop));
    EXPECT_EQ(set.missing().size(), 4u);
  }
  DataSet set(study_, "rubdata 0");
  EXPECT_EQ(set.missing().size(), 4u);
  EXPECT_TRUE(set.make(set.missing(), 1, nothing, std::atomic<bool>{false}));
  EXPECT_TRUE(set.missing().empty());
  set.finish({{"README.md", "a set"}});
  const std::string labels = text_of(study_.directory / "labels.csv");
  EXPECT_NE(labels.find("\n0,"), std::string::npos);
  EXPECT_NE(labels.find("\n5,"), std::string::npos);
}

TEST_F(DataSetTest, MissesARecordingWhoseFileIsGone) {
  DataSet set(study_, "rubdata 0");
  set.make(set.missing(), 1, nothing, std::atomic<bool>{false});
  for (const auto& entry : fs::recursive_directory_iterator(study_.directory))
    if (entry.path().filename() == "000003.csv") {
      fs::remove(entry.path());
      break;
    }
  EXPECT_EQ(set.missing(), std::vector<std::size_t>{3});
}

/// A truncated recording, as after copying to a full disk, is made again.
TEST_F(DataSetTest, MissesARecordingThatIsNotAsItWasWritten) {
  DataSet set(study_, "rubdata 0");
  set.make(set.missing(), 1, nothing, std::atomic<bool>{false});
  set.finish({{"README.md", "a set"}});
  const std::string labels = text_of(study_.directory / "labels.csv");
  for (const auto& entry : fs::recursive_directory_iterator(study_.directory))
    if (entry.path().filename() == "000002.csv") fs::resize_file(entry.path(), 40);
  EXPECT_EQ(set.missing(), std::vector<std::size_t>{2});
  set.make(set.missing(), 1, nothing, std::atomic<bool>{false});
  EXPECT_TRUE(set.missing().empty());
  set.finish({{"README.md", "a set"}});
  EXPECT_EQ(text_of(study_.directory / "labels.csv"), labels);
}

TEST_F(DataSetTest, RemovesWhatKilledProcessesLeft) {
  { const DataSet set(study_, "rubdata 0"); }
  for (const char* name : {"000001.mat.part", "000001.mat.part.tmp-host-12", "000003.csv.tmp-host-12",
                           "mine.mat.part", "000001.csv.tmp-old"})
    std::ofstream(study_.directory / "test" / name) << "half";
  const DataSet set(study_, "rubdata 0");
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(study_.directory / "test"))
    left.insert(entry.path().filename());
  EXPECT_EQ(left, (std::set<std::string>{"mine.mat.part", "000001.csv.tmp-old"}));
}

TEST_F(DataSetTest, RefusesTheDirectoryOfAnotherStudyOrBuild) {
  { const DataSet set(study_, "rubdata 0"); }
  EXPECT_THROW(DataSet(study_, "rubdata 0", "another digest"), ConfigError);
  study_.seed = 2;
  EXPECT_THROW(DataSet(study_, "rubdata 0"), ConfigError);
}

TEST_F(DataSetTest, IsOfOneProcessAtATime) {
  const DataSet set(study_, "rubdata 0");
  EXPECT_THROW(DataSet(study_, "rubdata 0"), LockedError);
}

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

TEST_F(DataSetTest, IsReadAsARecording) {
  for (const bool plane : {true, false}) {
    const LabelledRecording written = recording_of(plane);
    expect_same(recording::read_delimited_text(recording_csv(written), "recording.csv"), written, 1e-6);
  }
}

TEST_F(DataSetTest, TimesOfALongRecordingAtAHighRateAreThose) {
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

TEST_F(DataSetTest, MatlabFileHoldsTheNumbersAsTheyAre) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "recording.mat";
  for (const bool plane : {true, false}) {
    const LabelledRecording written = recording_of(plane);
    write_recording_matlab(written, file);
    expect_same(recording::read_matlab_file(batch::read_input(file), "recording.mat"), written, 0);
  }
}

TEST_F(DataSetTest, RefusesADirectoryThatIsNotThere) {
  EXPECT_THROW(write_recording_matlab(recording_of(true), "/nowhere/recording.mat"), IoError);
}

/// Limits the size of all files of this process during its lifetime, as on a full disk.
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

TEST_F(DataSetTest, MatlabFileThatDoesNotFitOnTheDiskIsRefusedAndLeavesNothing) {
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
