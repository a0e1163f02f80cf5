#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>

#include "rubsweep/analysis/branch/families/family_records.hpp"
#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::journal {

/// SHA-1 of map_digest and of the other compiled libraries on which families of orbits depend.
extern const char* const family_digest;

/// Directory of a map while a process follows its families. families.journal holds the results until they are
/// in the result files; families.lock names the process.
class FamilyJournal {
 public:
  /// Begins a call, or continues an interrupted one; `fresh`: first removes earlier results. Throws
  /// LockedError where another process works there, ConfigError where the journal belongs to another study or
  /// program, and IoError.
  FamilyJournal(const std::filesystem::path& directory, const sweep::Study& study, bool fresh);

  families::FamilyRecords& records() { return records_; }

  /// Number of records from an earlier call.
  std::size_t found_before() const { return found_before_; }

  /// Removes the journal after the results were written.
  void remove();

  /// Writes the journal to the disk (fsync) where that is due (LineLog::refresh).
  void refresh();

  /// Unlocks the directory, for a process that ends at once. Waits for a line that is being written; no
  /// further line is written.
  void leave();

 private:
  void read(const batch::JournalHeader& header, bool fresh);

  std::filesystem::path path_;
  std::optional<batch::FileLock> lock_;
  std::mutex mutex_;  ///< guards the journal
  std::optional<batch::Journal> journal_;
  families::FamilyRecords records_;
  std::size_t found_before_ = 0;
};

}  // namespace rubsweep::branch::journal
