#include "rubsweep/measurement/recording/tdms_file.hpp"

#include <gtest/gtest.h>

#include "measurement/recording/instrument_files.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

using files::tdms_chunk, files::tdms_index, files::tdms_metadata, files::tdms_object, files::tdms_segment,
    files::tdms_whole;

std::string tdms_fault(const std::string& bytes) {
  try {
    read_tdms_file(bytes, "f.tdms");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(TdmsFile, ReadsSegmentsAndChunks) {
  const auto all = files::signals(40);
  const std::string first = tdms_chunk(all, 0, 20), second = tdms_chunk(all, 20, 40);
  for (const std::string& bytes :
       {tdms_segment(tdms_whole, tdms_metadata(20), first + second),
        tdms_segment(tdms_whole, tdms_metadata(20), first) + tdms_segment(files::tdms_raw, "", second)}) {
    const Channels table = read_tdms_file(bytes, "f.tdms");
    ASSERT_EQ(table.channels.size(), 2u);
    EXPECT_EQ(table.channels[0].name, "X");
    EXPECT_EQ(table.channels[1].name, "Y's");
    EXPECT_EQ(table.channels[1].unit, "um");
    EXPECT_EQ(table.channels[0].values, all.x);
    EXPECT_EQ(table.channels[1].values, all.y);
    EXPECT_EQ(table.sampling_rate_hz, 1000);
    EXPECT_TRUE(table.notes.empty());
  }
}

TEST(TdmsFile, ReadsInterleavedChannels) {
  const auto all = files::signals(20);
  files::Bytes raw;
  for (std::size_t k = 0; k < 20; ++k) raw.add(all.x[k]).add(all.y[k]);
  const Channels table = read_tdms_file(
      tdms_segment(tdms_whole | files::tdms_interleaved, tdms_metadata(20), raw.text), "f.tdms");
  EXPECT_EQ(table.channels[0].values, all.x);
  EXPECT_EQ(table.channels[1].values, all.y);
}

TEST(TdmsFile, ReadsCountsAndTimeStampsAndTellsTheRest) {
  files::Bytes raw;
  for (const int value : {1, -2, 3}) raw.add(static_cast<std::uint16_t>(value), 2);
  for (const int k : {0, 1, 2})
    raw.add(std::uint64_t{1} << 62, 8).add(3000000000u + static_cast<unsigned>(k), 8);
  raw.add(7, 1);
  const std::string metadata =
      files::Bytes().add(3, 4).text + tdms_object("/'a'/'X'", tdms_index(2, 3), "", 0) +
      tdms_object("/'a'/'t'", tdms_index(0x44, 3), "", 0) + tdms_object("/'b'/'X'", tdms_index(1, 1), "", 0);
  const Channels table = read_tdms_file(tdms_segment(tdms_whole, metadata, raw.text), "f.tdms");
  ASSERT_EQ(table.channels.size(), 2u);
  EXPECT_EQ(table.channels[0].name, "a/X");
  EXPECT_EQ(table.channels[0].values, (std::vector<double>{1, -2, 3}));
  EXPECT_EQ(table.channels[1].values, (std::vector<double>{0.25, 1.25, 2.25}));
  EXPECT_EQ(table.channels[1].unit, "s");
  EXPECT_EQ(table.left_out_text(), " ('b/X' has 1 of 3 numbers)");
  EXPECT_FALSE(table.sampling_rate_hz);
}

TEST(TdmsFile, RefusesCountsWhoseScalesAreNotApplied) {
  files::Bytes raw;
  for (const int value : {1, 2, 3}) raw.add(static_cast<std::uint16_t>(value), 2);
  const std::string scales =
      files::tdms_text("NI_Number_Of_Scales") + files::Bytes().add(7, 4).add(std::uint64_t{1}, 4).text;
  const std::string metadata =
      files::Bytes().add(1, 4).text + tdms_object("/'a'/'X'", tdms_index(2, 3), scales, 1);
  EXPECT_NE(tdms_fault(tdms_segment(tdms_whole, metadata, raw.text)).find("scales that are not applied"),
            std::string::npos);
}

TEST(TdmsFile, WhatWasNotClosedIsReadAndTold) {
  const auto all = files::signals(20);
  std::string bytes = tdms_segment(tdms_whole, tdms_metadata(20), tdms_chunk(all, 0, 20));
  bytes.replace(12, 8, 8, '\xff');
  const Channels table = read_tdms_file(bytes, "f.tdms");
  EXPECT_EQ(table.channels[0].values, all.x);
  EXPECT_EQ(table.notes.size(), 1u);
}

TEST(TdmsFile, RefusesDamageAndRawDataOfDaqmx) {
  const std::string whole =
      tdms_segment(tdms_whole, tdms_metadata(20), tdms_chunk(files::signals(20), 0, 20));
  EXPECT_EQ(tdms_fault(whole.substr(0, whole.size() - 1)), "f.tdms: breaks off, allowed: a whole TDMS file");
  EXPECT_NE(tdms_fault(whole + "TDSx").find("a segment does not begin"), std::string::npos);
  EXPECT_NE(tdms_fault(tdms_segment(tdms_whole | files::tdms_daqmx, tdms_metadata(20), "")).find("DAQmx"),
            std::string::npos);
  EXPECT_NE(
      tdms_fault(tdms_segment(tdms_whole, tdms_metadata(std::size_t{1} << 60), "")).find("holds more than"),
      std::string::npos);
  EXPECT_NE(tdms_fault(tdms_segment(0x02, files::Bytes().add(0xffffffff, 4).text, "")).find("breaks off"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::recording
