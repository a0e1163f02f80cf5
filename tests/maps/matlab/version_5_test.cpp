#include "rubsweep/maps/matlab/version_5.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "maps/batch/temporary_directory.hpp"
#include "maps/matlab/matio_file.hpp"
#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {
namespace {

TEST(Version5, NoBitOfACompressedFileCanChangeWithoutAWord) {
  const TemporaryDirectory directory;
  MatioFile file(directory.path() / "a.mat", MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
  std::vector<double> wave(64);
  for (std::size_t k = 0; k < wave.size(); ++k) wave[k] = std::sin(0.3 * static_cast<double>(k));
  file.doubles("t_s", 8, 1, {0, 1, 2, 3, 4, 5, 6, 7});
  file.doubles("x_m", 64, 1, wave);
  const std::string bytes = file.close();
  ASSERT_EQ(fault(bytes), "nothing");
  const auto truth = read_all(bytes);
  constexpr std::size_t head = 128;
  for (std::size_t i = head; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ 1 << bit);
      if (fault(changed) != "nothing") continue;
      const auto read = read_all(changed);
      ASSERT_EQ(read.size(), truth.size()) << i << ' ' << bit;
      for (std::size_t k = 0; k < read.size(); ++k) {
        EXPECT_EQ(read[k].name, truth[k].name) << i << ' ' << bit;
        EXPECT_EQ(read[k].values, truth[k].values) << i << ' ' << bit;
      }
    }
  }
}

std::string little(std::uint32_t number) {
  return {static_cast<char>(number), static_cast<char>(number >> 8), static_cast<char>(number >> 16),
          static_cast<char>(number >> 24)};
}

TEST(Version5, AFewBytesThatClaimGigabytesAreRefusedBeforeTheyAreUnpacked) {
  constexpr std::uint32_t numbers = 500'000'000;
  std::string array = little(6) + little(8) + little(6) + little(0) + little(5) + little(8) +
                      little(numbers) + little(1) + little(1) + little(3) + std::string("t_s\0\0\0\0\0", 8) +
                      little(9) + little(8 * numbers);
  array = little(14) + little(static_cast<std::uint32_t>(array.size()) + 8 * numbers) + array +
          std::string(100000, '\0');
  uLongf size = compressBound(array.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(array.data()),
           array.size());
  packed.resize(size);
  std::string bytes =
      version_5_file("MATLAB 5.0", {}) + little(15) + little(static_cast<std::uint32_t>(size)) + packed;
  EXPECT_LT(bytes.size(), 1000u);
  EXPECT_EQ(fault(bytes), "holds more than 67108864 numbers");
}

TEST(Version5, TheOtherOrderOfBytes) {
  const auto large = [](std::uint32_t number) {
    std::string raw = little(number);
    std::ranges::reverse(raw);
    return raw;
  };
  std::string bytes = version_5_file("MATLAB 5.0", {});
  bytes.replace(124, 4, std::string("\1\0MI", 4));
  const std::string array = large(6) + large(8) + large(6) + large(0) + large(5) + large(8) + large(1) +
                            large(2) + large(1 << 16 | 1) + std::string("K\0\0\0", 4) + large(2 << 16 | 1) +
                            std::string("\5\xFE\0\0", 4);
  bytes += large(14) + large(static_cast<std::uint32_t>(array.size())) + array;
  EXPECT_EQ(find(read_all(bytes), "K").values, (std::vector<double>{5, -2}));
}

TEST(Version5, WhatIsWrittenIsReadByAnotherLibrary) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.mat";
  const std::vector<double> times{0, 0.1, 0.2}, values{1e-300, -2, 3};
  const std::vector<NamedVector> columns{{"t_s", times}, {"keyphasor_v", values}};
  std::ofstream(path, std::ios::binary) << version_5_file("MATLAB 5.0 MAT-file, by a test", columns);
  mat_t* file = Mat_Open(path.c_str(), MAT_ACC_RDONLY);
  ASSERT_NE(file, nullptr);
  for (const auto& [name, numbers] : columns) {
    matvar_t* variable = Mat_VarRead(file, std::string(name).c_str());
    ASSERT_NE(variable, nullptr) << name;
    ASSERT_EQ(variable->dims[0] * variable->dims[1], 3u);
    EXPECT_TRUE(std::ranges::equal(std::span(static_cast<const double*>(variable->data), 3), numbers))
        << name;
    Mat_VarFree(variable);
  }
  Mat_Close(file);
}

std::string packed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
           text.size());
  bytes.resize(size);
  return bytes;
}

TEST(Version5, GivesAllOrTheBegin) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += std::to_string(i);
  EXPECT_EQ(inflate_all(packed(text), text.size()), text);
  EXPECT_EQ(inflate_begin(packed(text), 8), "01234567");
  EXPECT_EQ(inflate_begin(packed("abc"), 8), "abc");
  EXPECT_EQ(inflate_all(packed(""), 0), "");
}

TEST(Version5, RefusesWhatIsLongerOrDamaged) {
  const std::string good = packed("a rotor that touches its casing");
  EXPECT_THROW(inflate_all(packed(std::string(100000, 'a')), 99999), FileError);
  EXPECT_THROW(inflate_all(good.substr(0, good.size() - 1), 100), FileError);
  std::string changed = good;
  changed.back() = static_cast<char>(changed.back() ^ 1);  // one bit of the checksum
  EXPECT_THROW(inflate_all(changed, 100), FileError);
  EXPECT_THROW(inflate_all("", 100), FileError);
}

}  // namespace
}  // namespace rubsweep::matlab
