#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rubsweep::batch {

/// The whole content of a file. Throws IoError with the path and the system's reason.
std::string read_whole_file(const std::filesystem::path& path);

/// Makes `path` hold exactly `text`, whole or not at all: writes a temporary file beside it, waits until that
/// is on the disk, then renames it. On any failure removes the temporary, leaves an older `path` as it was
/// and throws IoError with the path and the system's reason. Not for two threads and one path.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// A text file that grows by whole lines, each handed to the system at once, so that it can be watched and
/// survives the end of the process, however that comes.
class LineLog {
 public:
  /// Appends to `path` or creates it. A last line without an end (an interrupted write) is cut off first.
  /// Throws IoError.
  explicit LineLog(std::filesystem::path path);
  ~LineLog();
  LineLog(const LineLog&) = delete;
  LineLog& operator=(const LineLog&) = delete;

  /// Adds `line` and a line end. Throws IoError.
  void append(std::string_view line);

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace rubsweep::batch
