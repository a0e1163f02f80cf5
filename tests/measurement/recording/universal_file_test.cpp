#include "rubsweep/measurement/recording/universal_file.hpp"

#include <gtest/gtest.h>

#include "measurement/recording/instrument_files.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

using files::binary_universal_set, files::universal_set, files::UniversalForm;

const std::string other_sets =
    "    -1\n   151\nmodel\nof today\nprogram\n    -1\n    -1\n   164\n         1SI\n  1.0  1.0\n    -1\n";

std::string universal_fault(const std::string& bytes) {
  try {
    read_universal_file(bytes, "f.uff");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

void expect_near(const std::vector<double>& read, const std::vector<double>& written, double digits) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t k = 0; k < read.size(); ++k) EXPECT_NEAR(read[k], written[k], digits) << k;
}

TEST(UniversalFile, ReadsSetsOfTextAndOfBinaryNumbers) {
  const auto all = files::signals(100);
  for (const bool even : {true, false})
    for (const int ordinate : {2, 4}) {
      const UniversalForm form{.ordinate = ordinate, .even = even};
      const double digits = ordinate == 2 ? 1e-4 : 1e-9;
      for (const std::string& bytes :
           {universal_set("X", all.x, form) + universal_set("Y", all.y, form),
            binary_universal_set("X", all.x, false, form) + binary_universal_set("Y", all.y, false, form),
            binary_universal_set("X", all.x, true, form) + binary_universal_set("Y", all.y, true, form)}) {
        ASSERT_TRUE(is_universal_file(bytes));
        const Channels table = read_universal_file(other_sets + bytes, "f.uff");
        ASSERT_EQ(table.channels.size(), 3u);
        EXPECT_EQ(table.channels[0].name, "time");
        EXPECT_NEAR(table.channels[0].values[99], 0.599, 1e-6);
        EXPECT_EQ(table.channels[2].name, "Y");
        EXPECT_EQ(table.channels[2].unit, "um");
        expect_near(table.channels[1].values, all.x, digits);
        expect_near(table.channels[2].values, all.y, digits);
        EXPECT_EQ(table.sampling_rate_hz.has_value(), even);
        EXPECT_EQ(table.sampling_rate_hz.value_or(1000), 1000);
      }
    }
}

TEST(UniversalFile, SetsOfOneTitleAreNamedByPointAndDirection) {
  const auto all = files::signals(10);
  const Channels table = read_universal_file(
      universal_set("Run 7", all.x) + universal_set("Run 7", all.y, {.direction = -2}), "f.uff");
  EXPECT_EQ(table.channels[1].name, "Run 7 7:+X");
  EXPECT_EQ(table.channels[2].name, "Run 7 7:-Y");
}

TEST(UniversalFile, TellsWhatIsNoSignal) {
  const auto all = files::signals(10);
  const Channels table = read_universal_file(
      other_sets + universal_set("X", all.x) + universal_set("H", all.y, {.function = 4}) +
          universal_set("short", {1, 2, 3}) + universal_set("late", all.y, {.even = false}),
      "f.uff");
  EXPECT_EQ(table.channels.size(), 3u);  // the last one has the same times
  EXPECT_EQ(table.left_out_text(),
            " ('data set 151' is no recording, 'data set 164' is no recording, 'H' is no time history, but a "
            "function of type 4, 'short' has 3 readings instead of 10)");
  EXPECT_NE(universal_fault(other_sets).find("holds no signal"), std::string::npos);
}

TEST(UniversalFile, DamagedFilesAreRefusedAtTheirLine) {
  const auto all = files::signals(10);
  const std::string whole = universal_set("X", all.x);
  EXPECT_TRUE(universal_fault(whole.substr(0, whole.size() - 30)).starts_with("f.uff:1"))
      << universal_fault(whole);
  std::string word = whole;
  word.replace(word.rfind("e+0"), 3, "x+0");
  EXPECT_NE(universal_fault(word).find("is no number of this data set"), std::string::npos);
  std::string many = whole;
  many.replace(many.find("        10         1 "), 10, "  99999999");
  EXPECT_TRUE(universal_fault(many).starts_with("f.uff:9:1: has no kind, count or step of numbers"))
      << universal_fault(many);
  const std::string binary = binary_universal_set("X", all.x, false);
  EXPECT_NE(universal_fault(binary.substr(0, binary.size() - 40)).find("announces other bytes"),
            std::string::npos);
  EXPECT_FALSE(is_universal_file("-1,2\n58,3\n"));
  EXPECT_FALSE(is_universal_file("  -1\n"));
}

}  // namespace
}  // namespace rubsweep::recording
