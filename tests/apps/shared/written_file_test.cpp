#include "shared/written_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"

namespace rubsweep::apps {
namespace {

class WrittenFile : public testing::Test {
 protected:
  std::filesystem::path put(const char* name, std::string_view text) const {
    std::filesystem::create_directories((directory_.path() / name).parent_path());
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
    return directory_.path() / name;
  }

  TemporaryDirectory directory_;
};

TEST_F(WrittenFile, IsOursByItsHead) {
  EXPECT_TRUE(origin_of(put("a.csv", "# rubsweep 1\n# digest 2\nx\n1\n")).ours);
  EXPECT_EQ(origin_of(put("a.csv", "x\n1\n")).why_not, "says no program that wrote it");
  EXPECT_EQ(origin_of(put("a.csv", "")).why_not, "is empty");
  const auto pipe = directory_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(origin_of(pipe).why_not, "it is not a regular file");
  EXPECT_EQ(begin_of(pipe), "");
  EXPECT_EQ(begin_of(put("long", std::string(100'000, 'x'))).size(), 4096u);
}

TEST_F(WrittenFile, HasOneOfItsSums) {
  const auto file = put("a.wav", "RIFF");
  EXPECT_EQ(problem_of(file, {batch::sha256_of("other"), batch::sha256_of("RIFF")}), "");
  EXPECT_TRUE(
      problem_of(file, {batch::sha256_of("other")}).starts_with("is not as it was written: its sha256 is "));
  EXPECT_EQ(problem_of(file, {""}), "");
  EXPECT_EQ(problem_of(put("b", ""), {""}), "is empty");
  EXPECT_EQ(problem_of(directory_.path() / "nowhere", {""}), "is missing");
}

TEST_F(WrittenFile, KeptCasesSayTheirSum) {
  const std::string body = std::string("1\n2\0", 4),
                    head = "rubdiagnose cases abc " + batch::sha256_of(body) + '\n';
  EXPECT_EQ(are_cases_whole(put("a.cases", head + body)), true);
  EXPECT_EQ(are_cases_whole(put("a.cases", head + body + "x")), false);
  EXPECT_EQ(are_cases_whole(put("a.cases", head.substr(0, head.size() - 1))), false);
  EXPECT_EQ(are_cases_whole(put("a.cases", "of wine")), std::nullopt);
}

TEST_F(WrittenFile, RecordingsOfASetAreThoseOfItsLabels) {
  put("training/000000.csv", "t_s,x_m\n0,1\n");
  put("test/000001.mat", "MATLAB");
  const auto labels = directory_.path() / "labels.csv";
  const auto write = [&](const std::string& second) {
    batch::TableFile file(labels, {"rubdata 1", "abc", {}});
    file.write("recording,file,sha256\n0,training/000000.csv," + batch::sha256_of("t_s,x_m\n0,1\n") +
               "\n1,test/000001.mat," + second + "\n");
    file.commit();
  };
  write(batch::sha256_of("MATLAB"));
  EXPECT_TRUE(check_set(labels).faults.empty());
  EXPECT_EQ(check_set(labels).whole, 2u);
  put("test/000001.mat", "MATLAP");
  std::filesystem::remove(directory_.path() / "training/000000.csv");
  const CheckedRecordings checked = check_set(labels);
  ASSERT_EQ(checked.faults.size(), 2u);
  EXPECT_EQ(checked.faults[0], "training/000000.csv: is missing");
  EXPECT_TRUE(checked.faults[1].starts_with("test/000001.mat: is not as it was written"));
}

}  // namespace
}  // namespace rubsweep::apps
