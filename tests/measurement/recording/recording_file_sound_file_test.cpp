#include <gtest/gtest.h>
#include <sndfile.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"

namespace rubsweep::recording {
namespace {

namespace fs = std::filesystem;

TEST(RecordingFileSoundFile, ReadingsAreSharesOfTheFullScale) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "readings.wav";
  for (const int format : {SF_FORMAT_PCM_16, SF_FORMAT_PCM_24, SF_FORMAT_FLOAT}) {
    SF_INFO info{.frames = 0,
                 .samplerate = 12800,
                 .channels = 2,
                 .format = SF_FORMAT_WAV | format,
                 .sections = 0,
                 .seekable = 0};
    SNDFILE* sound = sf_open(file.c_str(), SFM_WRITE, &info);
    const std::vector<double> frames{0, 0.5, 0.25, -0.5, -1, 0.125};
    ASSERT_EQ(sf_writef_double(sound, frames.data(), 3), 3);
    sf_close(sound);
    const Channels table = read_sound_file(file);
    EXPECT_EQ(table.sampling_rate_hz, 12800);
    ASSERT_EQ(table.channels.size(), 2u);
    EXPECT_EQ(table.channels[1].name, "channel 2");
    EXPECT_EQ(table.channels[0].unit, full_scale_unit);
    ASSERT_EQ(table.channels[1].values.size(), 3u);
    EXPECT_NEAR(table.channels[1].values[1], -0.5, 1e-4);
    EXPECT_NEAR(table.channels[0].values[2], -1, 1e-4);
  }
}

TEST(RecordingFileSoundFile, DamagedOnesAreNamed) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "damaged.wav";
  std::ofstream(file) << "RIFF....WAVEjunk";
  try {
    read_sound_file(file);
    ADD_FAILURE() << "it was read";
  } catch (const ConfigError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": ")) << error.what();
  }
}

TEST(RecordingFileSoundFile, OneThatWasCutShortIsRefused) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "cut.wav";
  SF_INFO info{.frames = 0,
               .samplerate = 12800,
               .channels = 1,
               .format = SF_FORMAT_WAV | SF_FORMAT_PCM_16,
               .sections = 0,
               .seekable = 0};
  SNDFILE* sound = sf_open(file.c_str(), SFM_WRITE, &info);
  const std::vector<double> frames(1000, 0.5);
  ASSERT_EQ(sf_writef_double(sound, frames.data(), 1000), 1000);
  sf_close(sound);
  EXPECT_EQ(read_sound_file(file).rows(), 1000u);
  fs::resize_file(file, 1044);
  try {
    read_sound_file(file);
    ADD_FAILURE() << "it was read";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()),
              file.string() + ": breaks off after 1044 of 2044 bytes, allowed: a whole WAV file");
  }
}

}  // namespace
}  // namespace rubsweep::recording
