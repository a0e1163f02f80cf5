#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::batch {

enum class LockMode {
  exclusive,  ///< nobody else may hold the lock
  shared      ///< others may share it
};

enum class Patience {
  none,  ///< a lock that somebody else holds is an error
  wait   ///< until whoever holds it frees it, for locks that nobody holds for long
};

/// A lock that a process holds as long as this lives: the system releases it however the process ends. It is
/// a file that says who holds it; a file that nobody holds (its process was killed) means nothing.
class FileLock {
 public:
  /// Throws LockedError "PATH is held by HOLDER", IoError when there can be no such file. `purpose` is told
  /// to whoever finds the lock taken, where the file may be written: that of a dead owner in a directory
  /// where nobody else may remove it goes on naming him.
  FileLock(std::filesystem::path path, LockMode mode, const std::string& purpose,
           Patience patience = Patience::none);
  ~FileLock();  ///< removes the file unless others share the lock, or it is no longer the one that was locked
  /// False where the file system has no locks: then nothing keeps others away.
  bool guards() const { return guards_; }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  std::optional<Descriptor> descriptor_;
  bool guards_ = true;
};

/// "PROGRAM: DIRECTORY: this file system has no locks: ..." and a line end, to be told where a lock does not
/// guard.
std::string no_locks(std::string_view program, const std::filesystem::path& directory);

/// Who holds the lock at `path`; empty when nobody does, where the file system has no locks, or there is no
/// such file. Throws IoError.
std::optional<std::string> lock_holder(const std::filesystem::path& path);

}  // namespace rubsweep::batch
