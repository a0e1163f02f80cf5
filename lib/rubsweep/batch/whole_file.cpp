#include "rubsweep/batch/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>

namespace rubsweep::batch {
namespace {

constexpr std::size_t buffer_bytes = 65536;

/// Two processes that write one path do not share a temporary, nor do two hosts of one file system.
std::filesystem::path beside(std::filesystem::path path) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return path += fmt::format(".tmp-{}-{}", host.data(), ::getpid());
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) throw_io_error("read", path, errno);
  std::string text;
  std::array<char, buffer_bytes> piece;
  std::size_t length = 0;
  while ((length = std::fread(piece.data(), 1, piece.size(), file)) > 0) text.append(piece.data(), length);
  const int error = std::ferror(file) ? errno : 0;
  std::fclose(file);
  if (error != 0) throw_io_error("read", path, error);
  return text;
}

WholeFile::WholeFile(std::filesystem::path path)
    : path_(std::move(path)),
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
