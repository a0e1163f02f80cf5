#include "rubsweep/batch/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "rubsweep/error.hpp"

namespace rubsweep::batch {
namespace {

[[noreturn]] void fail(std::string_view action, const std::filesystem::path& path, int error) {
  throw IoError(
      fmt::format("cannot {} {}: {}", action, path.string(), std::generic_category().message(error)));
}

/// Returns -1 and sets errno on failure. `how`: O_TRUNC or O_APPEND.
int open_to_write(const std::filesystem::path& path, int how) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | how, 0666);
}

/// Writes everything; returns 0 or the system's error number.
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

void cut_unfinished_line(const std::filesystem::path& path) {
  std::error_code unknown;  // what cannot be looked at cannot be opened either, and open tells why
  if (!std::filesystem::is_regular_file(path, unknown)) return;
  const std::string text = read_whole_file(path);
  const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 is 0: no line is whole
  if (whole != text.size() && ::truncate(path.c_str(), static_cast<off_t>(whole)) != 0)
    fail("shorten", path, errno);
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) fail("read", path, errno);
  std::string text;
  std::array<char, 65536> piece;
  std::size_t length = 0;
  while ((length = std::fread(piece.data(), 1, piece.size(), file)) > 0) text.append(piece.data(), length);
  const int error = std::ferror(file) ? errno : 0;
  std::fclose(file);
  if (error != 0) fail("read", path, error);
  return text;
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::path temporary = path;
  temporary += fmt::format(".tmp-{}", ::getpid());
  const int descriptor = open_to_write(temporary, O_TRUNC);
  if (descriptor < 0) fail("write", path, errno);
  int error = write_all(descriptor, text);
  if (error == 0 && ::fsync(descriptor) != 0) error = errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  fail("write", path, error);
}

LineLog::LineLog(std::filesystem::path path) : path_(std::move(path)) {
  cut_unfinished_line(path_);
  descriptor_ = open_to_write(path_, O_APPEND);
  if (descriptor_ < 0) fail("write", path_, errno);
}

LineLog::~LineLog() { ::close(descriptor_); }

void LineLog::append(std::string_view line) {
  const int error = write_all(descriptor_, std::string(line) + '\n');
  if (error != 0) fail("write", path_, error);
}

}  // namespace rubsweep::batch
