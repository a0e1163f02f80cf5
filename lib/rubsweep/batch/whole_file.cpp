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

constexpr std::size_t buffer_bytes = 65536;

/// Two processes that write one path do not share a temporary, nor do two hosts of one file system.
std::filesystem::path beside(std::filesystem::path path) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return path += fmt::format(".tmp-{}-{}", host.data(), ::getpid());
}

/// The file behind a symbolic link. Throws IoError where that is a device or a pipe; of a directory the
/// system says so when it is to be replaced.
std::filesystem::path regular(std::filesystem::path path) {
  std::error_code none;
  constexpr int most_links = 40;  // of a circle, the system says so when the file is opened
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, none); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path);
  if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none) &&
      !std::filesystem::is_directory(path, none)) {
    throw IoError(fmt::format("{}: is not a regular file", path.string()));
  }
  return path;
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path path)
    : path_(regular(std::move(path))),
      temporary_(beside(path_)),
      descriptor_(open_file(temporary_, O_WRONLY | O_CREAT | O_TRUNC, "write", path_)) {}

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

void WholeFile::commit() {
  flush();
  if (::fsync(descriptor_.get()) != 0 || ::close(descriptor_.release()) != 0 ||
      std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw_io_error("write", path_, errno);
  }
  committed_ = true;
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace rubsweep::batch
