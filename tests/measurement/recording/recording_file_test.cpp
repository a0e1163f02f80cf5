#include "rubsweep/measurement/recording/recording_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"

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

TEST(RecordingFileDelimitedText, ReadsWhatInstrumentsWrite) {
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

TEST(RecordingFileDelimitedText, ColumnsOfWordsAreLeftOutAndTold) {
  const auto table = read_delimited_text("t,x,Status\n0,1,OK\n1,2,OVL\n", "f");
  ASSERT_EQ(table.channels.size(), 2u);
  EXPECT_EQ(table.left_out_text(), " ('Status' holds text, as in line 2)");
  const auto few = read_delimited_text("t\tx\tComment\n0\t1\tbegin\n1\t2\n", "f");
  expect_channel(few.channels[1], "x", "", {1, 2});
}

TEST(RecordingFileDelimitedText, OfLabViewOneSegmentIsRead) {
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

TEST(RecordingFileDelimitedText, TimeStampsBecomeSeconds) {
  const auto late = read_delimited_text("23:59:59,5;1\n00:00:00,5;2\n", "f");
  EXPECT_EQ(late.channels[0].values, (std::vector<double>{0, 1}));
  const auto dated = read_delimited_text("2024-02-28 23:59:59,1\n2024-02-29 00:00:01,2\n", "f");
  EXPECT_EQ(dated.channels[0].values, (std::vector<double>{0, 2}));
}

TEST(RecordingFileDelimitedText, EmptyCellsAreGaps) {
  const auto table = read_delimited_text("a,b\n1,2\n,\n3,NaN\n", "f");
  EXPECT_TRUE(std::isnan(table.channels[0].values[1]));
  EXPECT_TRUE(std::isnan(table.channels[1].values[2]));
}

TEST(RecordingFileDelimitedText, DamagedFilesAreRefusedAtTheirPlace) {
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

namespace fs = std::filesystem;

Channels read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return read_matlab_file(std::string(std::istreambuf_iterator<char>(stream), {}), file.string());
}

class RecordingFileMatlabFile : public testing::TestWithParam<mat_ft> {
 protected:
  mat_t* create() { return Mat_CreateVer(file_.c_str(), nullptr, GetParam()); }

  template <class Number>
  static void write(mat_t* file, const char* name, matio_classes kind, matio_types type,
                    std::vector<Number> values, std::size_t columns) {
    std::array<std::size_t, 2> dims{values.size() / columns, columns};
    matvar_t* variable = Mat_VarCreate(name, kind, type, 2, dims.data(), values.data(), 0);
    Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }

  const TemporaryDirectory directory_;
  const fs::path file_ = directory_.path() / "recording.mat";
};

TEST_P(RecordingFileMatlabFile, VectorsAndColumnsBecomeChannels) {
  mat_t* file = create();
  write<double>(file, "t_s", MAT_C_DOUBLE, MAT_T_DOUBLE, {0, 0.1, 0.2}, 1);
  write<float>(file, "probes", MAT_C_SINGLE, MAT_T_SINGLE, {1, 2, 3, 4, 5, 6}, 2);
  write<std::int16_t>(file, "counts", MAT_C_INT16, MAT_T_INT16, {-7, 8, 9}, 3);
  write<double>(file, "fs", MAT_C_DOUBLE, MAT_T_DOUBLE, {10}, 1);
  write<double>(file, "settings", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2}, 1);
  Mat_Close(file);
  const Channels table = read(file_);
  ASSERT_EQ(table.channels.size(), 4u);
  // Version 7.3 stores its variables in alphabetical order.
  const auto channel = [&](const char* name) {
    return *std::ranges::find(table.channels, std::string(name), &Channel::name);
  };
  EXPECT_EQ(channel("t_s").unit, "s");
  EXPECT_EQ(channel("t_s").values, (std::vector<double>{0, 0.1, 0.2}));
  EXPECT_EQ(channel("probes_1").values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(channel("probes_2").values, (std::vector<double>{4, 5, 6}));
  EXPECT_EQ(channel("counts").values, (std::vector<double>{-7, 8, 9}));
  EXPECT_EQ(table.place_of(1), "reading 2");
}

TEST_P(RecordingFileMatlabFile, SignalsMayLieInRows) {
  mat_t* file = create();
  write<double>(file, "probes", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6}, 3);
  write<double>(file, "t_s", MAT_C_DOUBLE, MAT_T_DOUBLE, {0, 0.1, 0.2}, 3);
  Mat_Close(file);
  const Channels table = read(file_);
  ASSERT_EQ(table.channels.size(), 3u);
  EXPECT_EQ(table.channels[0].values, (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(table.channels[1].name, "probes_2");
  EXPECT_EQ(table.channels[1].values, (std::vector<double>{2, 4, 6}));
}

TEST_P(RecordingFileMatlabFile, WhatIsLeftOutIsTold) {
  mat_t* file = create();
  write<double>(file, "picture", MAT_C_DOUBLE, MAT_T_DOUBLE, std::vector<double>(300 * 257), 257);
  write<double>(file, "t_s", MAT_C_DOUBLE, MAT_T_DOUBLE, {0, 0.1, 0.2}, 3);
  write<double>(file, "x", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2}, 1);
  Mat_Close(file);
  EXPECT_EQ(read(file_).left_out_text(),
            " ('picture' is 300 x 257, more than 256 signals, 'x' has 2 of 3 numbers)");
}

TEST_P(RecordingFileMatlabFile, FilesWithoutSignalsAreRefused) {
  mat_t* file = create();
  write<double>(file, "fs", MAT_C_DOUBLE, MAT_T_DOUBLE, {10}, 1);
  Mat_Close(file);
  EXPECT_THROW(read(file_), ConfigError);
}

INSTANTIATE_TEST_SUITE_P(Versions, RecordingFileMatlabFile, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73));

TEST(RecordingFileMatlabFileDamaged, IsNamed) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "damaged.mat";
  std::ofstream(file) << "MATLAB 5.0 MAT-file and nothing behind it";
  try {
    read(file);
    ADD_FAILURE() << "it was read";
  } catch (const ConfigError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": ")) << error.what();
  }
}

std::string fault(const char* file, std::string_view bytes) {
  try {
    read_recording_file(file, bytes);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(RecordingFile, TheFirstBytesSayWhatItIs) {
  EXPECT_EQ(read_recording_file("any.txt", "a,b\n1,2\n3,4\n").channels.size(), 2u);
  // These files do not exist; the reader chosen by the first bytes reports that.
  EXPECT_NE(fault("/nowhere/a.csv", "RIFF....WAVE").find("allowed: a WAV file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.dat", "MATLAB 5.0 MAT-file").find("MATLAB file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "\x89HDF\r\n").find("a.mat: is HDF5 without MATLAB's head, allowed: "),
            std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "old").find("MATLAB file"), std::string::npos);
}

/// A table of our programs can be a recording, but only if it was not changed.
TEST(RecordingFile, ATableWithAWrongSumIsRefused) {
  const std::string head = "# rubtrace 1\n# digest x\n# format 1\n",
                    rows = "t_s,sensor_0_m\n0,1e-6\n1,2e-6\n";
  const std::string sum = "# sha256 " + batch::sha256_of(head + rows) + "\n";
  EXPECT_EQ(read_recording_file("sensors.csv", head + sum + rows).channels.size(), 2u);
  std::string other = head + sum + rows;
  other[other.size() - 3] = '9';
  EXPECT_THROW(read_recording_file("sensors.csv", other), batch::DamagedTable);
  EXPECT_THROW(read_recording_file("sensors.csv", head + rows), batch::DamagedTable);
}

std::string write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return text;
}

/// Text of a recording by one probe at 90 degrees at 1 kHz, with a shaft speed of 25 Hz.
std::string vibration() {
  std::string text = "x [um]\n";
  for (int k = 0; k < 1000; ++k)
    text += fmt::format("{}\n", 30 * std::cos(2 * std::numbers::pi * 25 * k / 1000.0));
  return text;
}

TEST(RecordingFileReadRecording, IsTheRecordingItsInstrumentAndTheTextOfBoth) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "r.csv", instrument = directory.path() / "r.yaml";
  const std::string signal = write_text(file, vibration());
  const std::string description =
      write_text(instrument, "probes: [{column: x, angle_deg: 90}]\nspeed_hz: 25\nsampling_rate_hz: 1000\n");
  const ReadRecording read = read_recording(file, instrument);
  EXPECT_NEAR(read.recording.mean_speed_hz(), 25, 1e-9);
  EXPECT_GE(read.recording.turns(), 23);
  ASSERT_EQ(read.instrument.probes.size(), 1u);
  EXPECT_EQ(read.instrument.probes[0].angle_deg, 90);
  EXPECT_EQ(read.text, description + signal);
}

TEST(RecordingFileReadRecording, NamesTheFileThatIsWrong) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "r.csv", instrument = directory.path() / "r.yaml";
  write_text(file, vibration());
  const auto fault = [&] {
    try {
      read_recording(file, instrument);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  write_text(instrument, "probes: [{column: x, angle_deg: 90}]\nspeed_hz: fast\nsampling_rate_hz: 1000\n");
  EXPECT_TRUE(fault().starts_with(instrument.string() + ":2:")) << fault();
  write_text(instrument, "probes: [{column: y, angle_deg: 90}]\nspeed_hz: 25\nsampling_rate_hz: 1000\n");
  EXPECT_TRUE(fault().starts_with(file.string())) << fault();
}

}  // namespace
}  // namespace rubsweep::recording
