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

/// Creates a vector. The receiver must free it.
matvar_t* vector(const char* name, std::vector<double> values) {
  std::array<std::size_t, 2> dims{values.size(), 1};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims.data(), values.data(), 0);
}

TEST_P(RecordingFileMatlabFile, StructuresAndCellsMayLieInEachOther) {
  mat_t* file = create();
  const char* run_names[] = {"signals", "fs"};
  const char* signal_names[] = {"values"};
  std::array<std::size_t, 2> one{1, 1}, two{2, 1};
  matvar_t* run = Mat_VarCreateStruct("run", 2, one.data(), run_names, 2);
  matvar_t* signals = Mat_VarCreateStruct("signals", 2, two.data(), signal_names, 1);
  Mat_VarSetStructFieldByName(signals, "values", 0, vector("values", {1, 2, 3}));
  Mat_VarSetStructFieldByName(signals, "values", 1, vector("values", {4, 5, 6}));
  Mat_VarSetStructFieldByName(run, "signals", 0, signals);
  Mat_VarSetStructFieldByName(run, "fs", 0, vector("fs", {2000}));
  Mat_VarWrite(file, run, MAT_COMPRESSION_NONE);
  Mat_VarFree(run);
  std::array<matvar_t*, 2> parts{vector("", {7, 8, 9}), vector("", {10, 11, 12})};
  matvar_t* cells = Mat_VarCreate("probes", MAT_C_CELL, MAT_T_CELL, 2, two.data(), parts.data(), 0);
  Mat_VarWrite(file, cells, MAT_COMPRESSION_NONE);
  Mat_VarFree(cells);
  Mat_Close(file);
  const Channels table = read(file_);
  const auto values = [&](const char* name) {
    const auto found = std::ranges::find(table.channels, std::string(name), &Channel::name);
    return found == table.channels.end() ? std::vector<double>() : found->values;
  };
  EXPECT_EQ(table.channels.size(), 4u);
  EXPECT_EQ(values("run.signals.values"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(values("run.signals(2).values"), (std::vector<double>{4, 5, 6}));
  EXPECT_EQ(values("probes{1}"), (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(values("probes{2}"), (std::vector<double>{10, 11, 12}));
  EXPECT_EQ(table.sampling_rate_hz, 2000);
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
  EXPECT_NE(fault("/nowhere/a.dat", "TDSm").find("TDMS"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.dat", "    -1\n    58\n").find("data set 58"), std::string::npos);
  // These files do not exist. The reader of each format would report this.
  EXPECT_NE(fault("/nowhere/a.csv", "RIFF....WAVE").find("allowed: a WAV file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.dat", "MATLAB 5.0 MAT-file").find("MATLAB file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "\x89HDF\r\n").find("a.mat: is HDF5 without MATLAB's head, allowed: "),
            std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "old").find("MATLAB file"), std::string::npos);
}

/// A table written by our programs is accepted as a recording only if its checksum is right.
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
