#include "shared/writable.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::apps {

namespace fs = std::filesystem;

void require_writable(const fs::path& file, bool makes_directories) {
  std::error_code none;
  if (fs::is_directory(file, none)) batch::throw_io_error("write", file, EISDIR);
  if (fs::exists(file, none) && !fs::is_regular_file(file, none))
    throw IoError(fmt::format("{}: is not a regular file", file.string()));
  fs::path directory = fs::absolute(file).parent_path();
  while (makes_directories && !fs::exists(directory, none) && directory.has_relative_path())
    directory = directory.parent_path();
  if (!fs::exists(directory, none)) batch::throw_io_error("write", file, ENOENT);
  if (!fs::is_directory(directory, none)) batch::throw_io_error("write", file, ENOTDIR);
  if (::access(directory.c_str(), W_OK | X_OK) != 0) batch::throw_io_error("write", file, errno);
}

}  // namespace rubsweep::apps
