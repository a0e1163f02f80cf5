#include "rubsweep/recording/recording_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rubsweep/error.hpp"

namespace rubsweep::recording {
namespace {

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
  // No such files: who is asked to open them says so.
  EXPECT_NE(fault("/nowhere/a.csv", "RIFF....WAVE").find("allowed: a WAV file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.dat", "MATLAB 5.0 MAT-file").find("MATLAB file"), std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "\x89HDF\r\n").find("a.mat: is HDF5 without MATLAB's head, allowed: "),
            std::string::npos);
  EXPECT_NE(fault("/nowhere/a.mat", "old").find("MATLAB file"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::recording
