#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::batch {

enum class LockMode {
  exclusive,  ///< no other process may hold the lock
  shared      ///< others may share it
};

enum class Patience {
  none,  ///< throws where somebody else holds the lock
  wait   ///< waits for the lock; only for locks that are held briefly
};

/// Lock that a process holds during the life of this object. The system releases it however the process ends.
/// The locked file names the holder. If the holder was killed, the file remains, but is no longer locked.
class FileLock {
 public:
  /// Throws LockedError "PATH is held by HOLDER", and IoError where the file cannot be created. `purpose` is
  /// written to the file, for other processes that find it locked. The file may belong to a dead process of
  /// another user, in a directory where only this user may remove it. It is then locked, but still names its
  /// old owner.
  FileLock(std::filesystem::path path, LockMode mode, const std::string& purpose,
           Patience patience = Patience::none);
  ~FileLock();  ///< removes the file, unless others share the lock or the file was replaced
  /// False where the file system has no locks, so that other processes are not excluded.
  bool guards() const { return guards_; }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  std::optional<Descriptor> descriptor_;
  bool guards_ = true;
};

/// Warning for a lock that does not guard: "PROGRAM: DIRECTORY: this file system has no locks: ..." and a
/// line end.
std::string no_locks(std::string_view program, const std::filesystem::path& directory);

/// Holder of the lock at `path`. Empty where nobody holds it, where the file system has no locks, or where
/// the file does not exist. Throws IoError.
std::optional<std::string> lock_holder(const std::filesystem::path& path);

}  // namespace rubsweep::batch
