#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::batch {

/// A file that appears under its name whole or not at all: the text goes to a temporary beside it, which
/// takes the name at the end; a symbolic link stays, a device or pipe is refused. Temporaries that killed
/// processes left of the same file are removed at the start. Not for two threads and one path. Every function
/// throws IoError with the path and the system's reason, and then an older file of that name is as it was.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the temporary unless commit() succeeded
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view text);

  /// Descriptor for another process that writes instead, as its standard output.
  int descriptor() const { return descriptor_.get(); }

  /// Overwrites earlier text at `offset`.
  void write_at(std::size_t offset, std::string_view text);

  /// Waits until everything is on the disk, still under the name of the temporary. Nothing may be written
  /// afterwards.
  void finish();

  /// Finishes, then renames, and waits until the name is on the disk as well.
  void commit();

  /// The same without that wait, for one of several files of a directory that is synced after the last.
  void rename();

 private:
  void flush();
  Descriptor open_temporary() const;

  std::filesystem::path path_, temporary_;
  Descriptor descriptor_;
  std::string waiting_;  ///< not yet handed to the system
  bool finished_ = false, committed_ = false;
};

/// The file behind a symbolic link. Throws IoError where that is a device or a pipe; of a directory the
/// system says so when it is to be replaced.
std::filesystem::path file_behind(std::filesystem::path path);

/// Makes `path` hold exactly `text`, whole or not at all (see WholeFile).
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// Remembers that this process put a whole file in place. For any thread.
void note_written_file(const std::filesystem::path& path);

/// Files that this process put in place and that are still there, each once, in the order in which they came.
std::vector<std::filesystem::path> written_files();

/// Whether such a name is that of a temporary; one that only looks similar, as map.csv.tmp-old, is not.
bool is_temporary(std::string_view name);

/// Removes from `directory` the temporaries that killed processes left of files for whose name `is_ours`. A
/// temporary that a living process locks stays, and so does one that cannot be locked.
void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours);

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
