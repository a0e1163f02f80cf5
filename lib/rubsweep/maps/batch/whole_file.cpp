#include "rubsweep/maps/batch/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <system_error>
#include <unordered_set>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

struct Files {
  std::vector<std::filesystem::path> in_order;
  std::unordered_set<std::string> names;
};

std::mutex mutex;  // guards the list of files

Files& files() {
  static Files of_this_process;
  return of_this_process;
}

constexpr std::size_t buffer_bytes = 65536;

constexpr std::string_view mark = ".tmp-";

/// Removes a temporary file unless it is locked: its writer keeps it locked until it is renamed (see
/// WholeFile).
void remove_where_nobody_writes(const std::filesystem::path& file) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (opened.get() < 0 || ::flock(opened.get(), LOCK_EX | LOCK_NB) != 0) return;
  if (is_file_at(opened.get(), file)) ::unlink(file.c_str());
}

/// Name of the temporary file for `path`: in the same directory, and different from the names that other
/// processes and hosts use.
std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::filesystem::path temporary = path;
  return temporary += fmt::format("{}{}-{}", mark, host.data(), ::getpid());
}

/// Size of a file in bytes, 0 for a device. Throws where the size is unknown, because a file that counts as
/// empty would be truncated.
off_t size_of(int descriptor, const std::filesystem::path& path) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) throw_io_error("look at", path, errno);
  return S_ISREG(facts.st_mode) ? facts.st_size : 0;
}

/// Length of the file up to the end of its last complete line. Reads backwards, so that the time does not
/// depend on the size of the file.
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

WholeFile::WholeFile(std::filesystem::path path)
    : path_(file_behind(std::move(path))), temporary_(temporary_beside(path_)), descriptor_([this] {
        const std::string own = path_.filename();
        remove_leftovers(path_.parent_path(), [&](std::string_view name) { return name == own; });
        return open_temporary();
      }()) {}

/// Opens the temporary file and locks it, so that no other process removes it as a leftover. Without locks in
/// the file system it is not protected.
Descriptor WholeFile::open_temporary() const {
  while (true) {
    Descriptor opened = open_file(temporary_, O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK, "write", path_);
    if (::flock(opened.get(), LOCK_EX) == 0 && !is_file_at(opened.get(), temporary_)) continue;
    struct stat facts {};
    if (::fstat(opened.get(), &facts) != 0) throw_io_error("write", path_, errno);
    if (!S_ISREG(facts.st_mode) || facts.st_nlink > 1)
      throw IoError(fmt::format("cannot write {}: {} is there and no temporary of ours", path_.string(),
                                temporary_.string()));
    if (::ftruncate(opened.get(), 0) != 0) throw_io_error("write", path_, errno);
    return opened;
  }
}

WholeFile::~WholeFile() {
  if (!committed_) ::unlink(temporary_.c_str());
}

void WholeFile::write(std::string_view text) {
  waiting_ += text;
  if (waiting_.size() >= buffer_bytes) flush();
}

void WholeFile::flush() {
  if (const int error = write_all(descriptor_.get(), waiting_)) throw_io_error("write", path_, error);
  waiting_.clear();
}

void WholeFile::write_at(std::size_t offset, std::string_view text) {
  flush();
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor_.get(), text.data(), text.size(), static_cast<off_t>(offset));
    if (written < 0 && errno != EINTR) throw_io_error("write", path_, errno);
    if (written < 0) continue;
    text.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::size_t>(written);
  }
}

void WholeFile::finish() {
  if (finished_) return;
  flush();
  if (::fsync(descriptor_.get()) != 0) throw_io_error("write", path_, errno);
  finished_ = true;
}

void WholeFile::commit() {
  rename();
  sync_directory(path_.parent_path());
}

void WholeFile::rename() {
  finish();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) throw_io_error("write", path_, errno);
  committed_ = true;
  note_written_file(path_);
  ::close(descriptor_.release());  // also unlocks the file, which now has its final name
}

std::filesystem::path file_behind(std::filesystem::path path) {
  std::error_code none;
  constexpr int most_links = 40;  // a cycle of links is reported when the file is opened
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, none); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path);
  if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none) &&
      !std::filesystem::is_directory(path, none)) {
    throw IoError(fmt::format("{}: is not a regular file", path.string()));
  }
  return path;
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  file.commit();
}

void note_written_file(const std::filesystem::path& path) {
  const std::lock_guard lock(mutex);
  if (files().names.insert(path.native()).second) files().in_order.push_back(path);
}

std::vector<std::filesystem::path> written_files() {
  const std::lock_guard lock(mutex);
  std::vector<std::filesystem::path> there = files().in_order;
  std::error_code none;
  std::erase_if(there, [&](const auto& path) { return !std::filesystem::exists(path, none); });
  return there;
}

bool is_temporary(std::string_view name) {
  const std::size_t place = name.rfind(mark), process = name.rfind('-') + 1;
  return place != std::string_view::npos && process > place + mark.size() && process < name.size() &&
         name.find_first_not_of("0123456789", process) == std::string_view::npos;
}

void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours) {
  std::error_code none;  // files of an unreadable directory stay
  for (std::filesystem::directory_iterator entry(directory.empty() ? "." : directory, none), end;
       !none && entry != end; entry.increment(none)) {
    const std::string name = entry->path().filename();
    if (is_temporary(name) && is_ours(std::string_view(name).substr(0, name.rfind(mark))))
      remove_where_nobody_writes(entry->path());
  }
}

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
  // A failure is ignored here, because the next process that opens the log also cuts off an incomplete line.
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
  // EINVAL comes from a device without a disk.
  if (::fdatasync(descriptor_.get()) != 0 && errno != EINVAL) sync_error_ = errno;
}

}  // namespace rubsweep::batch
