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

/// File that appears under its name whole or not at all. The text goes to a temporary file in the same
/// directory, which is renamed at the end. A symbolic link stays; a device or pipe is refused. Leftover
/// temporary files of killed processes are removed at the start. Two threads must not use the same path.
/// Every function throws IoError with path and reason; an older file with this name is then unchanged.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the temporary file unless commit() succeeded
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view text);

  /// Descriptor for another process that writes the file as its standard output.
  int descriptor() const { return descriptor_.get(); }

  /// Overwrites text written earlier, from `offset` on.
  void write_at(std::size_t offset, std::string_view text);

  /// Waits until everything is on the disk, still under the temporary name. Nothing may be written
  /// afterwards.
  void finish();

  /// Finishes and renames, then waits until the new name is on the disk, too.
  void commit();

  /// Finishes and renames without waiting for the disk: for several files of a directory that is synced after
  /// the last file.
  void rename();

 private:
  void flush();
  Descriptor open_temporary() const;

  std::filesystem::path path_, temporary_;
  Descriptor descriptor_;
  std::string waiting_;  ///< bytes not yet passed to the system
  bool finished_ = false, committed_ = false;
};

/// File to which a symbolic link leads. Throws IoError where it is a device or a pipe. A directory is refused
/// later, when the system cannot replace it.
std::filesystem::path file_behind(std::filesystem::path path);

/// Gives `path` exactly the content `text`, whole or not at all (see WholeFile).
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// Records that this process completed a file. Any thread may call it.
void note_written_file(const std::filesystem::path& path);

/// Files that this process completed and that still exist, each once, in the order of completion.
std::vector<std::filesystem::path> written_files();

/// Whether a name is that of a temporary file. A name that only looks similar, such as map.csv.tmp-old, is
/// not.
bool is_temporary(std::string_view name);

/// Removes from `directory` the temporary files that killed processes left, if `is_ours` accepts the final
/// name. Temporary files that a living process locks stay, and so do those that cannot be locked.
void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours);

/// Text file that grows by whole lines. Each line goes to the system at once, so that others can read it and
/// it survives a crash of the process. A loss of power loses at most the lines of the last `interval`,
/// provided that lines keep coming or `refresh` is called regularly.
class LineLog {
 public:
  static constexpr std::chrono::seconds sync_interval{5};

  /// Appends to `path`, or creates it. An incomplete last line (an interrupted write) is cut off first.
  /// Throws IoError, also for a symbolic link.
  explicit LineLog(std::filesystem::path path, std::chrono::milliseconds interval = sync_interval);

  /// Adds `line` and a line end. Throws IoError, and then removes the part already written if the system
  /// allows it.
  void append(std::string_view line);

  /// Syncs appended lines to the disk once `interval` is over. After a failure the next `append` throws.
  void refresh();
  /// Syncs at once, without waiting for the interval.
  void sync();

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  std::chrono::milliseconds interval_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
  bool appended_ = false;  ///< true: lines were appended since the last sync
  int sync_error_ = 0;
};

}  // namespace rubsweep::batch
