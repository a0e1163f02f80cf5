#include "rubsweep/measurement/recording/delimited_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <string>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

std::string text_fault(std::string_view text) {
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

TEST(DelimitedText, ColumnsOfTextAloneAreRefused) {
  std::string rows;
  for (int k = 0; k < 3; ++k) rows += "1,2,a,a,a\na,1,2,a,a\na,a,1,2,a\na,a,a,1,2\n2,a,a,a,1\n";
  EXPECT_NE(text_fault(rows).find("has no column of numbers"), std::string::npos) << text_fault(rows);
}

TEST(DelimitedText, APauseAtTheEndOfTheFirstThousandLinesLosesNoRows) {
  std::string text = "t\tx\n";
  for (int k = 0; k < 975; ++k) text += fmt::format("{}\t{}\n", k, k % 7);
  for (int k = 0; k < 30; ++k) text += "# pause\n";
  for (int k = 975; k < 1200; ++k) text += fmt::format("{}\t{}\n", k, k % 7);
  const Channels table = read_delimited_text(text, "f");
  EXPECT_EQ(table.rows(), 1200u);
  EXPECT_EQ(table.channels[1].name, "x");
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
  EXPECT_EQ(text_fault("a,b\n1,2\n3\n"),
            "f.csv:3:1: has another number of cells, 1, allowed: 2 as in line 2");
  EXPECT_EQ(text_fault("a,b\n1,2\n3, x1\n"),
            "f.csv:3:4: 'x1' is no number, allowed: a number with a decimal point");
  EXPECT_EQ(text_fault("1;2\n2,5;3\n3.5;3\n"),
            "f.csv:3:1: '3.5' is no number, allowed: a number with a decimal comma");
  EXPECT_EQ(
      text_fault("12:00:00;3\n13;3\n"),
      "f.csv:2:1: '13' is no time stamp, allowed: hours:minutes:seconds, with or without a date before them");
  EXPECT_EQ(text_fault("1,2\n"), "f.csv:1:1: is the only row of numbers, allowed: two or more");
  for (const char* empty : {"", "\n\n", "hello\nworld\n", "# 1,2\n"})
    EXPECT_TRUE(text_fault(empty).starts_with("f.csv:1:1: has no numbers, allowed: ")) << empty;
  EXPECT_TRUE(text_fault(std::string_view("1,2\n\0,3\n", 9)).starts_with("f.csv:1:1: is no text"));
}

TEST(DelimitedText, StampsMayStandInAnyColumnAndForm) {
  const auto second = read_delimited_text("Index,Time,X\n1,11:59:59.5 AM,1\n2,12:00:00.5 PM,2\n", "f");
  expect_channel(second.channels[1], "Time", "s", {0, 1});
  const auto zones =
      read_delimited_text("Stamp;X\n2024-10-27T02:59:59+02:00;1\n2024-10-27T02:00:00+01:00;2\n", "f");
  expect_channel(zones.channels[0], "Stamp", "s", {0, 1});
}

TEST(DelimitedText, NamesMaySayTheirUnits) {
  const auto table = read_delimited_text("Time/s;X_um;\"Y, mil\";KP mV;counts\n0;1;2;3;4\n1;2;3;4;5\n", "f");
  const char* units[] = {"s", "um", "mil", "mV", ""};
  ASSERT_EQ(table.channels.size(), std::size(units));
  for (std::size_t i = 0; i < std::size(units); ++i) EXPECT_EQ(table.channels[i].unit, units[i]) << i;
  EXPECT_EQ(table.channels[1].name, "X_um");
  // Not "s", and not "s2".
  const auto rates = read_delimited_text(
      "t_s,sensor_0_m_per_s2,v_mm_per_s,in_per_s,runs_per_day\n0,1,2,3,4\n1,2,3,4,5\n", "f");
  const char* units_of_rates[] = {"s", "m/s2", "mm/s", "in/s", ""};
  for (std::size_t i = 0; i < std::size(units_of_rates); ++i)
    EXPECT_EQ(rates.channels[i].unit, units_of_rates[i]) << i;
}

TEST(DelimitedText, OscilloscopesAreRead) {
  const auto counted = read_delimited_text("x-axis,1,2\nsecond,Volt,Volt\n0,1,2\n0.5,3,4\n", "f");
  expect_channel(counted.channels[2], "2", "Volt", {2, 4});
  const auto step =
      read_delimited_text("X,CH1,Start,Increment,\nSequence,Volt,0,1e-3,\n0,1,,\n1,2,,\n2,3,,\n", "f");
  ASSERT_EQ(step.channels.size(), 2u);
  EXPECT_EQ(step.channels[1].unit, "Volt");
  EXPECT_EQ(step.sampling_rate_hz, 1000);
  const auto keyed = read_delimited_text(
      "\"TraceName\",\"CH1\",\"CH2\"\n\"VUnit\",\"V\",\"mV\"\n\"SampleRate\",1e3,1e3\n,1,2,\n,3,4,\n,5,6,\n",
      "f");
  ASSERT_EQ(keyed.channels.size(), 2u);
  expect_channel(keyed.channels[1], "CH2", "mV", {2, 4, 6});
}

TEST(DelimitedText, NotesAndWordsInThePlaceOfReadingsAreNoHindrance) {
  const auto table =
      read_delimited_text("t,x\n0,1\nthe pump runs\n1,OVLD\nt,x\n2,\u221e\n3,4\n\nend of file\n", "f");
  ASSERT_EQ(table.rows(), 4u);
  EXPECT_TRUE(std::isnan(table.channels[1].values[1]));
  EXPECT_TRUE(std::isnan(table.channels[1].values[2]));
  ASSERT_EQ(table.notes.size(), 1u);
  EXPECT_EQ(table.notes[0], "line 3 holds words and no numbers and is passed over, as are 2 others");
}

TEST(DelimitedText, TheFirstLineThatBreaksTheTableIsNamed) {
  EXPECT_EQ(text_fault("t,x,y\n0,1,2\n1,2\n2,3,4\n"),
            "f.csv:3:1: has another number of cells, 2, allowed: 3 as in line 2");
  EXPECT_EQ(text_fault("t,x,y\n0,1,2\nwords\n1,2,3\n2;3;4\n"),
            "f.csv:5:1: has another number of cells, 1, allowed: 3 as in line 2");
}

TEST(DelimitedText, SignalsMayLieInRows) {
  std::string text = "t (ms)", x = "X (um)";
  for (int k = 0; k < 20; ++k) text += fmt::format(";{}", k), x += fmt::format(";{}", 2 * k);
  const auto table = read_delimited_text(text + '\n' + x + '\n', "f");
  ASSERT_EQ(table.channels.size(), 2u);
  EXPECT_EQ(table.channels[0].unit, "ms");
  EXPECT_EQ(table.channels[1].values.size(), 20u);
  EXPECT_EQ(table.channels[1].values[19], 38);
  EXPECT_FALSE(table.sampling_rate_hz);
  EXPECT_EQ(read_delimited_text("Sample rate: 2 kHz\n" + x + '\n' + x + '\n', "f").sampling_rate_hz, 2000);
}

TEST(DelimitedText, ALongHeadIsPassedOver) {
  std::string head;
  for (int k = 0; k < 2500; ++k) head += fmt::format("setting {} on\n", k);
  const auto table = read_delimited_text(head + "t (s),X (um)\n0,1\n1,2\n2,3\n", "f");
  expect_channel(table.channels[1], "X", "um", {1, 2, 3});
}

TEST(DelimitedText, OfSixteenBitsMayLackItsMark) {
  const std::string narrow = "t (s);X (um)\n0;1\n1;2\n2;3\n";
  for (const bool big : {false, true}) {
    std::string wide;
    for (const char c : narrow) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    expect_channel(read_delimited_text(wide, "f").channels[1], "X", "um", {1, 2, 3});
  }
}

}  // namespace
}  // namespace rubsweep::recording
