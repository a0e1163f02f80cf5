#include "rubscope/column_list.hpp"

#include <gtest/gtest.h>

#include "rubsweep/measurement/recording/delimited_text.hpp"

namespace rubsweep::apps {

using namespace recording;

namespace {

bool says(const std::string& list, std::string_view words) { return list.find(words) != std::string::npos; }

TEST(ColumnList, SaysWhatWasUnderstoodAndWhatWasNot) {
  const std::string list = column_list(
      read_delimited_text(
          "Rate,500\nt (s),X (um),KP,Status\n0,1.5,-2,OK\n0.002,2.5,OVLD,OK\nbegan\n0.004,3,-3,no\n", "f"),
      "run.csv");
  EXPECT_TRUE(says(list, "run.csv: 3 columns of 3 readings, from line 3 to line 6")) << list;
  EXPECT_TRUE(says(list, "500 readings a second, as the file says")) << list;
  EXPECT_TRUE(says(list, "'t' rises evenly, by 0.002 s")) << list;
  EXPECT_TRUE(says(list, "1.5 to 3")) << list;
  EXPECT_TRUE(says(list, "-2, nan, -3")) << list;
  EXPECT_TRUE(says(list, "left out  'Status' holds text")) << list;
  EXPECT_TRUE(says(list, "note      line 5 holds words and no numbers and is passed over")) << list;
  EXPECT_TRUE(says(list, "takes `unit: um`")) << list;
}

TEST(ColumnList, SaysThatThereIsNoClock) {
  const std::string list = column_list(read_delimited_text("x [um]\n1\n3\n2\n", "f"), "f");
  EXPECT_TRUE(says(list, "clock     none")) << list;
  EXPECT_FALSE(says(list, "takes `unit: um`")) << list;
}

TEST(ColumnList, AColumnInAnotherUnitIsNoClock) {
  const std::string list = column_list(read_delimited_text("t [ms],T [Deg C]\n0,20\n1,21\n2,22\n", "f"), "f");
  EXPECT_TRUE(says(list, "'t' rises evenly, by 1 ms")) << list;
  EXPECT_FALSE(says(list, "'T' rises evenly")) << list;
}

}  // namespace
}  // namespace rubsweep::apps
