#include "rubsweep/measurement/recording/delimited_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

std::string fault(std::string_view text) {
  try {
    read_delimited_text(text, "f.csv");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

void expect_channel(const Channel& channel, const char* name, const char* unit,
                    const std::vector<double>& values) {
  EXPECT_EQ(channel.name, name);
  EXPECT_EQ(channel.unit, unit);
  EXPECT_EQ(channel.values, values);
}

TEST(DelimitedText, ReadsWhatInstrumentsWrite) {
  const auto german =
      read_delimited_text("\xEF\xBB\xBFMessung 3\r\nZeit (s);X [mV]\r\n0,1;2,5\r\n0,2;-3\r\n", "f");
  ASSERT_EQ(german.channels.size(), 2u);
  expect_channel(german.channels[0], "Zeit", "s", {0.1, 0.2});
  expect_channel(german.channels[1], "X", "mV", {2.5, -3});
  EXPECT_EQ(german.line, (std::vector<std::size_t>{3, 4}));

  const auto units_below = read_delimited_text("# by a logger\nt\tx\ns\t(um)\n0\t1e-3\n% pause\n1\t2", "f");
  expect_channel(units_below.channels[0], "t", "s", {0, 1});
  expect_channel(units_below.channels[1], "x", "um", {1e-3, 2});
  EXPECT_EQ(units_below.line, (std::vector<std::size_t>{4, 6}));

  const auto ours = read_delimited_text("# digest\nt_s,sensor_0_m\n0,1e-6\n1,2e-6\n", "f");
  expect_channel(ours.channels[0], "t_s", "s", {0, 1});
  expect_channel(ours.channels[1], "sensor_0_m", "m", {1e-6, 2e-6});

  const auto bare = read_delimited_text("1,2\r3,4\r", "f");
  expect_channel(bare.channels[1], "column 2", "", {2, 4});
}

TEST(DelimitedText, ColumnsOfWordsAreLeftOutAndTold) {
  const auto table = read_delimited_text("t,x,Status\n0,1,OK\n1,2,OVL\n", "f");
  ASSERT_EQ(table.channels.size(), 2u);
  EXPECT_EQ(table.left_out_text(), " ('Status' holds text, as in line 2)");
  const auto few = read_delimited_text("t\tx\tComment\n0\t1\tbegin\n1\t2\n", "f");
  expect_channel(few.channels[1], "x", "", {1, 2});
}

TEST(DelimitedText, OfLabViewOneSegmentIsRead) {
  const std::string head =
      "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t2\t\t\n"
      "Samples\t3\t3\t\nY_Unit_Label\tum\tVolts\t\nDelta_X\t0.002\t0.002\t\n***End_of_Header***\t\t\t\n";
  const std::string rows = "X_Value\tX\tKP\tComment\n\t1.5\t-3.0\n\t2.5\t-9.0\n\t3.5\t-3.0\n";
  const auto table = read_delimited_text(head + rows, "f");
  ASSERT_EQ(table.channels.size(), 3u);
  expect_channel(table.channels[1], "X", "um", {1.5, 2.5, 3.5});
  expect_channel(table.channels[2], "KP", "Volts", {-3, -9, -3});
  EXPECT_EQ(table.sampling_rate_hz, 500);
  EXPECT_EQ(fault(head + rows + head.substr(head.find("Channels")) + rows),
            "f.csv:20:1: begins another segment of LabVIEW, allowed: one segment in a file");
}

TEST(DelimitedText, TimeStampsBecomeSeconds) {
  const auto late = read_delimited_text("23:59:59,5;1\n00:00:00,5;2\n", "f");
  EXPECT_EQ(late.channels[0].values, (std::vector<double>{0, 1}));
  const auto dated = read_delimited_text("2024-02-28 23:59:59,1\n2024-02-29 00:00:01,2\n", "f");
  EXPECT_EQ(dated.channels[0].values, (std::vector<double>{0, 2}));
}

TEST(DelimitedText, EmptyCellsAreGaps) {
  const auto table = read_delimited_text("a,b\n1,2\n,\n3,NaN\n", "f");
  EXPECT_TRUE(std::isnan(table.channels[0].values[1]));
  EXPECT_TRUE(std::isnan(table.channels[1].values[2]));
}

TEST(DelimitedText, DamagedFilesAreRefusedAtTheirPlace) {
  EXPECT_EQ(fault("a,b\n1,2\n3\n"), "f.csv:3:1: has another number of cells, 1, allowed: 2 as in line 2");
  EXPECT_EQ(fault("a,b\n1,2\n3, x1\n"),
            "f.csv:3:4: 'x1' is no number, allowed: a number with a decimal point");
  EXPECT_EQ(fault("1;2\n2,5;3\n3.5;3\n"),
            "f.csv:3:1: '3.5' is no number, allowed: a number with a decimal comma");
  EXPECT_EQ(
      fault("12:00:00;3\n13;3\n"),
      "f.csv:2:1: '13' is no time stamp, allowed: hours:minutes:seconds, with or without a date before them");
  EXPECT_EQ(fault("1,2\n"), "f.csv:1:1: is the only row of numbers, allowed: two or more");
  for (const char* empty : {"", "\n\n", "hello\nworld\n", "# 1,2\n"})
    EXPECT_TRUE(fault(empty).starts_with("f.csv:1:1: has no numbers, allowed: ")) << empty;
  EXPECT_TRUE(fault(std::string_view("1,2\n\0,3\n", 9)).starts_with("f.csv:1:1: is no text"));
}

}  // namespace
}  // namespace rubsweep::recording
