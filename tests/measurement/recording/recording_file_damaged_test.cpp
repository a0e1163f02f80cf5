#include <gtest/gtest.h>

#include <random>

#include "measurement/recording/instrument_files.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"

namespace rubsweep::recording {
namespace {

/// A file of each format. The files are small, so that a flipped bit is often in the head.
std::vector<std::string> small_files() {
  const auto all = files::signals(24);
  const auto row = [&](std::size_t k) { return fmt::format("\t{:.4f}\t{:.4f}", all.x[k], all.y[k]); };
  std::string stamps = "Rate=1000Hz;;\nTime;X (um);Y/um\n",
              beside = "Source,CH1,,0,1,\nVertical Units,V,,0.001,2,\n";
  for (std::size_t k = 0; k < 24; ++k) {
    stamps += fmt::format("2024-03-12 10:15:30,{:03};{:.3f};OVLD\n", k, all.x[k]);
    beside += fmt::format(",,,{:.3f},{:.4f},\n", 0.002 + 0.001 * static_cast<double>(k), all.y[k]);
  }
  std::string wide("\xff\xfe");
  for (const char c : stamps) wide += {c, '\0'};
  files::Bytes interleaved;
  for (std::size_t k = 0; k < 24; ++k) interleaved.add(all.x[k]).add(all.y[k]);
  return {stamps,
          wide,
          beside,
          files::universal_set("X", all.x) + files::universal_set("Y", all.y, {.ordinate = 2}),
          files::binary_universal_set("X", all.x, false) +
              files::binary_universal_set("Y", all.y, true, {.even = false}),
          files::tdms_segment(files::tdms_whole, files::tdms_metadata(12), files::tdms_chunk(all, 0, 24)),
          files::tdms_segment(files::tdms_whole | files::tdms_interleaved, files::tdms_metadata(24),
                              interleaved.text),
          files::labview_head("No") +
              files::labview_segment(24, "10:15:30.1", "X_Value\tX\tY\tComment", row) +
              files::labview_segment(24, "10:15:31.1", "X_Value\tX\tY\tComment", row)};
}

/// Bits are flipped, bytes are changed, or the end is cut off. Each file must be read or refused, without any
/// other failure.
TEST(RecordingFileDamaged, IsReadOrRefused) {
  std::mt19937 random(20);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  for (const std::string& whole : small_files()) {
    ASSERT_GT(read_recording_file("f.dat", whole).rows(), 1u);
    for (int trial = 0; trial < 120; ++trial) {
      std::string bytes = whole;
      for (std::size_t changes = below(6); changes > 0; --changes) {
        char& byte = bytes[below(trial % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 900))];
        byte = static_cast<char>(trial % 3 == 0 ? random()
                                                : static_cast<unsigned char>(byte) ^ (1u << below(8)));
      }
      if (trial % 5 == 0) bytes.resize(below(bytes.size()));
      try {
        const Channels table = read_recording_file("f.dat", bytes);
        ASSERT_FALSE(table.channels.empty());
        for (const Channel& channel : table.channels) ASSERT_EQ(channel.values.size(), table.rows());
      } catch (const ConfigError& error) {
        ASSERT_NE(std::string_view(error.what()).find(", allowed: "), std::string_view::npos) << error.what();
      }
    }
  }
}

/// Two files on which a search that starts again at every character would take too long: a line of 400 000
/// opening brackets, and long lines of cells.
TEST(RecordingFileDamaged, LongLinesTakeNoLongTime) {
  const std::string open = "a b\n" + std::string(400000, '(') + "\n1 2\n2 3\n3 4\n";
  EXPECT_EQ(read_recording_file("f.txt", open).channels.size(), 2u);
  std::string wide;
  for (int k = 0; k < 70000; ++k) wide += "1,";
  wide += "1\n";
  EXPECT_THROW(read_recording_file("f.txt", wide + wide), ConfigError);
}

}  // namespace
}  // namespace rubsweep::recording
