// Compares the complete message for every file of bad/ with the text beside it: the message is the interface.
#include <algorithm>
#include <filesystem>

#include "maps/config/support.hpp"

namespace rubsweep::config {
namespace {

std::vector<std::string> stems(const std::string& extension) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(CONFIG_TEST_DATA) + "/bad")) {
    if (entry.path().extension() == extension) found.push_back(entry.path().stem().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class BadFilesEach : public testing::TestWithParam<std::string> {};

TEST_P(BadFilesEach, GivesExactlyTheExpectedMessage) {
  // Bases are relative to the file, whose name appears in the message without a directory.
  std::filesystem::current_path(std::string(CONFIG_TEST_DATA) + "/bad");
  const std::string name = GetParam() + ".yaml";
  EXPECT_EQ(message_of(test_file("bad/" + name), {}, name) + "\n",
            test_file("bad/" + GetParam() + ".expected"));
}

INSTANTIATE_TEST_SUITE_P(Folder, BadFilesEach, testing::ValuesIn(stems(".yaml")),
                         [](const auto& parameter) { return parameter.param; });

TEST(BadFiles, AllHaveTheirMessageAndNoneIsLeftOver) {
  EXPECT_GE(stems(".yaml").size(), 25U);
  EXPECT_EQ(stems(".yaml"), stems(".expected"));
}

}  // namespace
}  // namespace rubsweep::config
