#include "shared/result_directory.hpp"

#include <unistd.h>

#include <atomic>
#include <string>
#include <system_error>
#include <vector>

#include "rubsweep/maps/batch/opened_file.hpp"
#include "shared/writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Directories made by this run, the deepest first. The list is complete before `made` becomes true, so a
/// signal handler may read it.
std::vector<std::string> made_directories;
std::atomic<bool> made{false};

}  // namespace

ResultDirectory::ResultDirectory(const fs::path& directory, std::span<const std::string_view> names) {
  std::error_code none;
  made_directories.clear();
  fs::path missing = fs::absolute(directory);
  if (!missing.has_filename()) missing = missing.parent_path();
  for (; !fs::exists(missing, none) && missing.has_relative_path(); missing = missing.parent_path())
    made_directories.push_back(missing.string());
  made = true;
  batch::make_directory(directory);
  for (const std::string_view name : names) require_writable(directory / name, false);
}

ResultDirectory::~ResultDirectory() {
  remove_empty_result_directories();
  made = false;
}

void remove_empty_result_directories() {
  if (!made) return;
  for (const std::string& directory : made_directories) {
    if (::rmdir(directory.c_str()) != 0) return;  // the directory is not empty
  }
}

}  // namespace rubsweep::apps
