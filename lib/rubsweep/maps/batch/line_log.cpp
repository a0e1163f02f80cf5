#include "rubsweep/maps/batch/line_log.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <utility>

namespace rubsweep::batch {
namespace {

/// Size of a file, 0 for a device. An unknown size must never pass for an empty file, which would be cut to
/// nothing.
off_t size_of(int descriptor, const std::filesystem::path& path) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) throw_io_error("look at", path, errno);
  return S_ISREG(facts.st_mode) ? facts.st_size : 0;
}

/// Length of the file up to the end of its last whole line: read from the end, whatever its size.
off_t whole_lines(int descriptor, const std::filesystem::path& path) {
  std::array<char, 4096> block;
  off_t end = size_of(descriptor, path);
  while (end > 0) {
    const off_t begin = std::max<off_t>(0, end - static_cast<off_t>(block.size()));
    const ssize_t length = ::pread(descriptor, block.data(), static_cast<std::size_t>(end - begin), begin);
    if (length != end - begin) throw_io_error("read", path, length < 0 ? errno : EIO);
    for (off_t i = end - begin; i > 0; --i) {
      if (block[static_cast<std::size_t>(i - 1)] == '\n') return begin + i;
    }
    end = begin;
  }
  return 0;
}

}  // namespace

LineLog::LineLog(std::filesystem::path path, std::chrono::milliseconds interval)
    : path_(std::move(path)),
      descriptor_(open_file(path_, O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW, "write")),
      interval_(interval) {
  const off_t whole = whole_lines(descriptor_.get(), path_);
  if (whole != size_of(descriptor_.get(), path_) && ::ftruncate(descriptor_.get(), whole) != 0) {
    throw_io_error("shorten", path_, errno);
  }
}

void LineLog::append(std::string_view line) {
  const off_t before = size_of(descriptor_.get(), path_);
  int error = write_all(descriptor_.get(), std::string(line) + '\n');
  // Best effort: the next one who opens the log cuts an unfinished line as well.
  if (error != 0) (void)!::ftruncate(descriptor_.get(), before);
  if (error != 0) throw_io_error("write", path_, error);
  appended_ = true;
  refresh();
  error = std::exchange(sync_error_, 0);
  if (error != 0) throw_io_error("write", path_, error);
}

void LineLog::refresh() {
  if (appended_ && std::chrono::steady_clock::now() - synced_ >= interval_) sync();
}

void LineLog::sync() {
  synced_ = std::chrono::steady_clock::now();
  appended_ = false;
  // EINVAL: a device that has no disk behind it.
  if (::fdatasync(descriptor_.get()) != 0 && errno != EINVAL) sync_error_ = errno;
}

}  // namespace rubsweep::batch
