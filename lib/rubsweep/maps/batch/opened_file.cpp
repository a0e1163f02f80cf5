#include "rubsweep/maps/batch/opened_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <system_error>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view is_a_link = "it is a symbolic link, and what that leads to would be changed";

bool is_passed_on(const fs::path& path) {
  const std::string& name = path.native();
  return name == "/dev/stdin" || name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/");
}

std::string reason(int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  return std::generic_category().message(error);
}

}  // namespace

void throw_io_error(std::string_view action, const fs::path& path, int error) {
  throw IoError(fmt::format("cannot {} {}: {}", action, path.string(), reason(error)));
}

Descriptor open_file(const fs::path& path, int flags, std::string_view action, const fs::path& known_as) {
  Descriptor descriptor(::open(path.c_str(), flags | O_CLOEXEC, 0666));
  if (descriptor.get() >= 0) return descriptor;
  if (errno == ELOOP && (flags & O_NOFOLLOW) != 0)
    throw IoError(fmt::format("cannot {} {}: {}", action, known_as.string(), is_a_link));
  throw_io_error(action, known_as, errno);
}

void refuse_link(std::string_view action, const fs::path& path) {
  std::error_code none;
  if (fs::is_symlink(path, none))
    throw IoError(fmt::format("cannot {} {}: {}", action, path.string(), is_a_link));
}

Descriptor::~Descriptor() {
  if (value_ >= 0) ::close(value_);
}

int Descriptor::release() { return std::exchange(value_, -1); }

bool is_file_at(int descriptor, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

void sync_directory(const fs::path& directory) {
  const fs::path named = directory.empty() ? fs::path(".") : directory;
  const Descriptor opened(::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A directory may be writable but not readable.
  if (opened.get() < 0 && errno == EACCES) return;
  if (opened.get() < 0) throw_io_error("read", named, errno);
  // EINVAL comes from a file system without a disk.
  if (::fsync(opened.get()) != 0 && errno != EINVAL && errno != ENOTSUP)
    throw_io_error("write", named, errno);
}

void make_directory(const fs::path& directory) {
  std::error_code error;
  const fs::path whole = fs::absolute(directory, error);
  fs::path before = whole;  // existing part of the path
  while (before.has_relative_path() && !fs::exists(before, error)) before = before.parent_path();
  error.clear();
  fs::create_directories(directory, error);
  if (error) throw IoError(fmt::format("{}: {}", directory.string(), error.message()));
  // Syncs all directories from the new one up to the one that existed, since each of them got a new entry.
  for (fs::path made = whole; made != before && made.has_relative_path();) {
    made = made.parent_path();
    sync_directory(made);
  }
}

Input find_input(const fs::path& path, InputKind kind) {
  if (kind == InputKind::also_passed_on && is_passed_on(path)) {
    Descriptor passed(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    const int error = errno;
    if (passed.get() >= 0) return {std::move(passed), ""};
    return {Descriptor(-1), reason(error)};
  }
  // Without O_NONBLOCK opening a pipe would wait for its other end.
  Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (descriptor.get() < 0)
    return {Descriptor(-1), errno == ENXIO ? "it is not a regular file" : reason(errno)};
  struct stat facts {};
  if (::fstat(descriptor.get(), &facts) != 0) return {Descriptor(-1), reason(errno)};
  if (S_ISDIR(facts.st_mode)) return {Descriptor(-1), reason(EISDIR)};
  if (!S_ISREG(facts.st_mode)) return {Descriptor(-1), "it is not a regular file"};
  return {std::move(descriptor), ""};
}

Descriptor open_input(const fs::path& path) {
  Input input = find_input(path);
  if (!input.problem.empty()) throw IoError(fmt::format("cannot read {}: {}", path.string(), input.problem));
  return std::move(input.descriptor);
}

InputLines::InputLines(fs::path path) : path_(std::move(path)), stream_(nullptr, &std::fclose) {
  Descriptor descriptor = open_input(path_);
  stream_.reset(::fdopen(descriptor.get(), "rb"));
  if (!stream_) throw_io_error("read", path_, errno);
  descriptor.release();
}

InputLines::~InputLines() { std::free(text_); }

std::string_view InputLines::next() {
  errno = 0;
  const ssize_t length = ::getline(&text_, &capacity_, stream_.get());
  if (length >= 0) return {text_, static_cast<std::size_t>(length)};
  if (errno == ENOMEM) throw std::bad_alloc();
  if (std::ferror(stream_.get())) throw_io_error("read", path_, errno);
  return {};
}

void InputLines::go_to(std::uint64_t offset) {
  if (::fseeko(stream_.get(), static_cast<off_t>(offset), SEEK_SET) != 0)
    throw_io_error("read", path_, errno);
}

int read_bytes(int descriptor, std::size_t most, std::string& text) {
  std::array<char, 65536> piece;
  while (most > 0) {
    const ssize_t length = ::read(descriptor, piece.data(), std::min(most, piece.size()));
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) return errno;
    if (length == 0) return 0;
    text.append(piece.data(), static_cast<std::size_t>(length));
    most -= static_cast<std::size_t>(length);
  }
  return 0;
}

std::string read_input(const fs::path& path) {
  const Descriptor file = open_input(path);
  std::string text;
  if (const int error = read_bytes(file.get(), text.max_size(), text)) throw_io_error("read", path, error);
  return text;
}

}  // namespace rubsweep::batch
