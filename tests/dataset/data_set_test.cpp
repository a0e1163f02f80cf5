#include "rubsweep/dataset/data_set.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "batch/temporary_directory.hpp"
#include "dataset/small_study.hpp"
#include "rubsweep/error.hpp"

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
  set.finish();
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

/// A recording that was cut off, as by a full disk behind a copy, is made again.
TEST_F(DataSetTest, MissesARecordingThatIsNotAsItWasWritten) {
  DataSet set(study_, "rubdata 0");
  set.make(set.missing(), 1, nothing, std::atomic<bool>{false});
  set.finish();
  const std::string labels = text_of(study_.directory / "labels.csv");
  for (const auto& entry : fs::recursive_directory_iterator(study_.directory))
    if (entry.path().filename() == "000002.csv") fs::resize_file(entry.path(), 40);
  EXPECT_EQ(set.missing(), std::vector<std::size_t>{2});
  set.make(set.missing(), 1, nothing, std::atomic<bool>{false});
  EXPECT_TRUE(set.missing().empty());
  set.finish();
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

}  // namespace
}  // namespace rubsweep::dataset
