#include "rubsweep/batch/written_files.hpp"

#include <algorithm>
#include <mutex>
#include <system_error>

namespace rubsweep::batch {
namespace {

std::mutex mutex;  // guards the files

std::vector<std::filesystem::path>& files() {
  static std::vector<std::filesystem::path> of_this_process;
  return of_this_process;
}

}  // namespace

void note_written_file(const std::filesystem::path& path) {
  const std::lock_guard lock(mutex);
  if (std::ranges::find(files(), path) == files().end()) files().push_back(path);
}

std::vector<std::filesystem::path> written_files() {
  const std::lock_guard lock(mutex);
  std::vector<std::filesystem::path> there = files();
  std::error_code none;
  std::erase_if(there, [&](const auto& path) { return !std::filesystem::exists(path, none); });
  return there;
}

}  // namespace rubsweep::batch
