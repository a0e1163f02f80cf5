#pragma once

#include <chrono>
#include <filesystem>
#include <string_view>

#include "rubsweep/batch/descriptor.hpp"

namespace rubsweep::batch {

/// A text file that grows by whole lines, each handed to the system at once, so that it can be watched and
/// survives the end of the process, however that comes. A loss of power costs at most the lines of the last
/// `sync_interval`.
class LineLog {
 public:
  static constexpr std::chrono::seconds sync_interval{5};

  /// Appends to `path` or creates it. A last line without an end (an interrupted write) is cut off first.
  /// Throws IoError, for a symbolic link as well.
  explicit LineLog(std::filesystem::path path);

  /// Adds `line` and a line end. Throws IoError; then nothing of the line stays behind if the system allows.
  void append(std::string_view line);

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

}  // namespace rubsweep::batch
