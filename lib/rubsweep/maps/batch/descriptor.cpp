#include "rubsweep/maps/batch/descriptor.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

constexpr std::string_view is_a_link = "it is a symbolic link, and what that leads to would be changed";

}  // namespace

void throw_io_error(std::string_view action, const std::filesystem::path& path, int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  throw IoError(
      fmt::format("cannot {} {}: {}", action, path.string(), std::generic_category().message(error)));
}

Descriptor open_file(const std::filesystem::path& path, int flags, std::string_view action,
                     const std::filesystem::path& known_as) {
  Descriptor descriptor(::open(path.c_str(), flags | O_CLOEXEC, 0666));
  if (descriptor.get() >= 0) return descriptor;
  if (errno == ELOOP && (flags & O_NOFOLLOW) != 0)
    throw IoError(fmt::format("cannot {} {}: {}", action, known_as.string(), is_a_link));
  throw_io_error(action, known_as, errno);
}

void refuse_link(std::string_view action, const std::filesystem::path& path) {
  std::error_code none;
  if (std::filesystem::is_symlink(path, none))
    throw IoError(fmt::format("cannot {} {}: {}", action, path.string(), is_a_link));
}

Descriptor::~Descriptor() {
  if (value_ >= 0) ::close(value_);
}

int Descriptor::release() { return std::exchange(value_, -1); }

bool is_file_at(int descriptor, const std::filesystem::path& path) {
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

}  // namespace rubsweep::batch
