#include "rubsweep/maps/batch/directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/descriptor.hpp"

namespace rubsweep::batch {

namespace fs = std::filesystem;

void sync_directory(const fs::path& directory) {
  const fs::path named = directory.empty() ? fs::path(".") : directory;
  const Descriptor opened(::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A directory may be one to write in and not to read.
  if (opened.get() < 0 && errno == EACCES) return;
  if (opened.get() < 0) throw_io_error("read", named, errno);
  // EINVAL: a file system that has no disk behind it.
  if (::fsync(opened.get()) != 0 && errno != EINVAL && errno != ENOTSUP)
    throw_io_error("write", named, errno);
}

void make_directory(const fs::path& directory) {
  std::error_code error;
  const fs::path whole = fs::absolute(directory, error);
  fs::path before = whole;  // the directory that is there already
  while (before.has_relative_path() && !fs::exists(before, error)) before = before.parent_path();
  error.clear();
  fs::create_directories(directory, error);
  if (error) throw IoError(fmt::format("{}: {}", directory.string(), error.message()));
  // From the new directory up to that one, each holds a new name.
  for (fs::path made = whole; made != before && made.has_relative_path();) {
    made = made.parent_path();
    sync_directory(made);
  }
}

}  // namespace rubsweep::batch
