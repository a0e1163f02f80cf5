#include "rubsweep/maps/batch/file_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

/// Number of refusals, within a tenth of a second, after which a lock counts as held. A single refusal is no
/// proof, since others may hold the lock only for an instant: a process that releases a shared lock, or one
/// that asks for the holder.
constexpr int most_refusals = 20;
constexpr std::chrono::milliseconds between_refusals{5};

bool has_no_such_locks(int error) {
  return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP || error == EINVAL;
}

/// Lock for a file system without flock(2), by fcntl(2) with locks of open files. Network file systems pass
/// these on to their server.
int lock_by_record(int descriptor, int operation) {
  struct flock whole {};
  whole.l_type = (operation & LOCK_EX) != 0 ? F_WRLCK : F_RDLCK;
  whole.l_whence = SEEK_SET;
  const int command = (operation & LOCK_NB) != 0 ? F_OFD_SETLK : F_OFD_SETLKW;
  while (::fcntl(descriptor, command, &whole) != 0) {
    if (errno == EAGAIN || errno == EACCES) return EWOULDBLOCK;
    if (errno != EINTR) return errno;
  }
  return 0;
}

/// Locks a file. Returns 0 or the system's error number: EWOULDBLOCK with LOCK_NB where somebody else holds
/// the lock, ENOLCK where the file system has no locks of any kind.
int lock(int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EINTR) continue;
    if (!has_no_such_locks(errno)) return errno;
    const int error = lock_by_record(descriptor, operation);
    return has_no_such_locks(error) || error == EBADF ? ENOLCK : error;
  }
  return 0;
}

constexpr std::string_view identity_mark = ", process ", identity_end = " UTC\n";

/// Text of a lock file: its purpose and its owner.
std::string identity(const std::string& purpose) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{}{}{} on {} since {:%Y-%m-%d %H:%M:%S}{}", purpose, identity_mark, ::getpid(),
                     host.data(), fmt::gmtime(now), identity_end);
}

/// Text of a lock file, read through the descriptor, since the file may have been removed or renamed.
std::string written_holder(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  const std::string_view written(text.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return written.empty() ? "another process" : std::string(written.substr(0, written.find('\n')));
}

/// Refuses a file that has a second name: it may belong to somebody else.
void require_own_file(int descriptor, const std::filesystem::path& path) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) throw_io_error("lock", path, errno);
  if (!S_ISREG(facts.st_mode))
    throw IoError(fmt::format("cannot lock {}: it is not a regular file", path.string()));
  if (facts.st_nlink > 1) {
    throw IoError(
        fmt::format("cannot lock {}: it has another name, too (a hard link), allowed: a directory "
                    "where it is removed",
                    path.string()));
  }
}

/// Refuses to overwrite any text that is not a line made by `identity`.
void require_own_text(int descriptor, const std::filesystem::path& path) {
  std::array<char, 1024> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  if (length < 0) throw_io_error("read", path, errno);
  const std::string_view written(text.data(), static_cast<std::size_t>(length));
  const bool one_line = written.find('\n') + 1 == written.size();
  if (written.empty() ||
      (one_line && written.find(identity_mark) != std::string_view::npos && written.ends_with(identity_end)))
    return;
  throw IoError(
      fmt::format("cannot lock {}: no program of ours wrote what it says, allowed: a directory where it "
                  "is removed",
                  path.string()));
}

/// Opens the file at `path` to be locked. The second value is true if the file may be written. In a shared
/// directory perhaps only the file's owner may write it; if that process is dead, the file can still be
/// locked.
std::pair<Descriptor, bool> open_lock(const std::filesystem::path& path) {
  constexpr int most_attempts = 3;  // another process may remove the file during an attempt
  for (int attempt = 1;; ++attempt) {
    constexpr int ours = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    const int writable = ::open(path.c_str(), O_RDWR | O_CREAT | ours, 0666);
    const int error = errno;
    const int readable = writable < 0 && error == EACCES ? ::open(path.c_str(), O_RDONLY | ours) : -1;
    Descriptor opened(writable >= 0 ? writable : readable);
    if (opened.get() >= 0) {
      require_own_file(opened.get(), path);
      return {std::move(opened), writable >= 0};
    }
    if (error == ELOOP) refuse_link("lock", path);
    if (error != EACCES || attempt == most_attempts) throw_io_error("lock", path, error);
  }
}

}  // namespace

FileLock::FileLock(std::filesystem::path path, LockMode mode, const std::string& purpose, Patience patience)
    : path_(std::move(path)) {
  const int operation = mode == LockMode::exclusive ? LOCK_EX : LOCK_SH;
  bool writable = false;
  for (int refusals = 0;;) {
    auto [descriptor, may_write] = open_lock(path_);
    const int error = patience == Patience::wait ? lock(descriptor.get(), operation)
                                                 : lock(descriptor.get(), operation | LOCK_NB);
    // The previous holder may have removed the file after we opened it and before we locked it.
    const bool still_there = is_file_at(descriptor.get(), path_);
    if (error == EWOULDBLOCK && still_there) {
      if (++refusals == most_refusals)
        throw LockedError(fmt::format("{} is held by {}", path_.string(), written_holder(descriptor.get())));
      std::this_thread::sleep_for(between_refusals);
      continue;
    }
    guards_ = error != ENOLCK;
    if (error != 0 && error != EWOULDBLOCK && guards_) throw_io_error("lock", path_, error);
    if (error == EWOULDBLOCK || !still_there) continue;  // the holder has just removed the file
    // Where the directory permits it, the file of a dead process is replaced by a new one.
    if (!may_write && mode == LockMode::exclusive && ::unlink(path_.c_str()) == 0) continue;
    writable = may_write;
    descriptor_.emplace(std::move(descriptor));
    break;
  }
  if (!writable) return;
  require_own_text(descriptor_->get(), path_);
  if (::ftruncate(descriptor_->get(), 0) != 0) throw_io_error("write", path_, errno);
  if (const int error = write_all(descriptor_->get(), identity(purpose))) {
    // an incomplete line would not be recognised as written by this program
    (void)!::ftruncate(descriptor_->get(), 0);
    throw_io_error("write", path_, error);
  }
}

FileLock::~FileLock() {
  // A new directory of the same name may have replaced the old one; its lock belongs to others.
  if ((!guards_ || lock(descriptor_->get(), LOCK_EX | LOCK_NB) == 0) && is_file_at(descriptor_->get(), path_))
    ::unlink(path_.c_str());
}

std::string no_locks(std::string_view program, const std::filesystem::path& directory) {
  return fmt::format("{}: {}: this file system has no locks: nothing keeps a second run away from it\n",
                     program, directory.string());
}

std::optional<std::string> lock_holder(const std::filesystem::path& path) {
  const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
  if (opened < 0 && errno == ENOENT) return std::nullopt;
  if (opened < 0 && errno == ELOOP) refuse_link("read", path);
  const Descriptor descriptor(opened);
  if (opened < 0) throw_io_error("read", path, errno);
  const int error = lock(descriptor.get(), LOCK_SH | LOCK_NB);
  if (error == 0 || error == ENOLCK) return std::nullopt;
  if (error != EWOULDBLOCK) throw_io_error("lock", path, error);
  return written_holder(descriptor.get());
}

}  // namespace rubsweep::batch
