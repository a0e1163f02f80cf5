#pragma once

#include <chrono>
#include <filesystem>
#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::batch {

/// A text file that grows by whole lines, each handed to the system at once, so that it can be watched and
/// survives the end of the process, however that comes. A loss of power costs at most what was appended in
/// the last `interval`, where lines keep coming or `refresh` is called now and then.
class LineLog {
 public:
  static constexpr std::chrono::seconds sync_interval{5};

  /// Appends to `path` or creates it. A last line without an end (an interrupted write) is cut off first.
  /// Throws IoError, for a symbolic link as well.
  explicit LineLog(std::filesystem::path path, std::chrono::milliseconds interval = sync_interval);

  /// Adds `line` and a line end. Throws IoError; then nothing of the line stays behind if the system allows.
  void append(std::string_view line);

  /// Asks for what was appended to be on the disk, once `interval` is over. A failure is what the next
  /// `append` throws.
  void refresh();
  /// The same at once.
  void sync();

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  std::chrono::milliseconds interval_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
  bool appended_ = false;  ///< since then
  int sync_error_ = 0;
};

}  // namespace rubsweep::batch
