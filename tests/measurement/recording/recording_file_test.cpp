#include "rubsweep/measurement/recording/recording_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"

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

/// A table that a program wrote is a recording as long as it is as that program left it.
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

}  // namespace
}  // namespace rubsweep::recording
