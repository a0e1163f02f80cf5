#include "rubsweep/batch/file_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::batch {
namespace {

/// 0, or the system's error number: EWOULDBLOCK when somebody else holds the lock.
int try_lock(int descriptor, int operation) {
  while (::flock(descriptor, operation | LOCK_NB) != 0) {
    if (errno != EINTR) return errno;
  }
  return 0;
}

/// The holder before us may have removed the file between our opening and our locking it.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

std::string identity(const std::string& purpose) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{}, process {} on {} since {:%Y-%m-%d %H:%M:%S} UTC", purpose, ::getpid(), host.data(),
                     fmt::gmtime(now));
}

std::string written_holder(const std::filesystem::path& path) {
  const std::string text = read_whole_file(path);
  return text.empty() ? "another process" : text.substr(0, text.find('\n'));
}

}  // namespace

FileLock::FileLock(std::filesystem::path path, LockMode mode, const std::string& purpose)
    : path_(std::move(path)) {
  do {
    descriptor_.emplace(open_file(path_, O_RDWR | O_CREAT, "lock"));
    const int error = try_lock(descriptor_->get(), mode == LockMode::exclusive ? LOCK_EX : LOCK_SH);
    if (error == EWOULDBLOCK) {
      throw LockedError(fmt::format("{} is held by {}", path_.string(), written_holder(path_)));
    }
    if (error != 0) throw_io_error("lock", path_, error);
  } while (!is_file_at(descriptor_->get(), path_));
  if (::ftruncate(descriptor_->get(), 0) != 0) throw_io_error("write", path_, errno);
  if (const int error = write_all(descriptor_->get(), identity(purpose) + '\n'))
    throw_io_error("write", path_, error);
}

FileLock::~FileLock() {
  if (try_lock(descriptor_->get(), LOCK_EX) == 0) ::unlink(path_.c_str());
}

std::optional<std::string> lock_holder(const std::filesystem::path& path) {
  const Descriptor descriptor = open_file(path, O_RDONLY, "read");
  const int error = try_lock(descriptor.get(), LOCK_SH);
  if (error == 0) return std::nullopt;
  if (error != EWOULDBLOCK) throw_io_error("lock", path, error);
  return written_holder(path);
}

}  // namespace rubsweep::batch
