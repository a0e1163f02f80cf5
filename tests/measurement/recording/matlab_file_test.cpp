#include "rubsweep/measurement/recording/matlab_file.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

namespace fs = std::filesystem;

Channels read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return read_matlab_file(std::string(std::istreambuf_iterator<char>(stream), {}), file.string());
}

class MatlabFile : public testing::TestWithParam<mat_ft> {
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

TEST_P(MatlabFile, VectorsAndColumnsBecomeChannels) {
  mat_t* file = create();
  write<double>(file, "t_s", MAT_C_DOUBLE, MAT_T_DOUBLE, {0, 0.1, 0.2}, 1);
  write<float>(file, "probes", MAT_C_SINGLE, MAT_T_SINGLE, {1, 2, 3, 4, 5, 6}, 2);
  write<std::int16_t>(file, "counts", MAT_C_INT16, MAT_T_INT16, {-7, 8, 9}, 3);
  write<double>(file, "fs", MAT_C_DOUBLE, MAT_T_DOUBLE, {10}, 1);
  write<double>(file, "settings", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2}, 1);
  Mat_Close(file);
  const Channels table = read(file_);
  ASSERT_EQ(table.channels.size(), 4u);
  // Version 7.3 keeps its variables in the order of the alphabet.
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

TEST_P(MatlabFile, SignalsMayLieInRows) {
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

TEST_P(MatlabFile, WhatIsLeftOutIsTold) {
  mat_t* file = create();
  write<double>(file, "picture", MAT_C_DOUBLE, MAT_T_DOUBLE, std::vector<double>(300 * 257), 257);
  write<double>(file, "t_s", MAT_C_DOUBLE, MAT_T_DOUBLE, {0, 0.1, 0.2}, 3);
  write<double>(file, "x", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2}, 1);
  Mat_Close(file);
  EXPECT_EQ(read(file_).left_out_text(),
            " ('picture' is 300 x 257, more than 256 signals, 'x' has 2 of 3 numbers)");
}

TEST_P(MatlabFile, FilesWithoutSignalsAreRefused) {
  mat_t* file = create();
  write<double>(file, "fs", MAT_C_DOUBLE, MAT_T_DOUBLE, {10}, 1);
  Mat_Close(file);
  EXPECT_THROW(read(file_), ConfigError);
}

INSTANTIATE_TEST_SUITE_P(Versions, MatlabFile, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73));

TEST(MatlabFileDamaged, IsNamed) {
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

}  // namespace
}  // namespace rubsweep::recording
