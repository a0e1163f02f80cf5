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

/// The map_digest and the compiled libraries that families of orbits depend on besides, as one SHA-1.
extern const char* const family_digest;

/// Directory in which families of a map are followed, while a process is at work there: families.journal
/// holds the results so far, until the result files have them, and families.lock names the process.
class FamilyJournal {
 public:
  /// Begins, or continues an interrupted call; `fresh`: after removing its results. Throws LockedError when
  /// another process is at work there, ConfigError when the journal belongs to another study or program,
  /// IoError.
  FamilyJournal(const std::filesystem::path& directory, const sweep::Study& study, bool fresh);

  families::FamilyRecords& records() { return records_; }

  /// Number of records read that an earlier call wrote.
  std::size_t found_before() const { return found_before_; }

  /// Removes the journal once the results are written.
  void remove();

  /// As LineLog::refresh.
  void refresh();

  /// Frees the directory, for a process that ends at once; waits for a line that is being written, and no
  /// other one comes after it.
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
