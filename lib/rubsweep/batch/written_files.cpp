#include "rubsweep/batch/written_files.hpp"

#include <mutex>
#include <string>
#include <system_error>
#include <unordered_set>

namespace rubsweep::batch {
namespace {

struct Files {
  std::vector<std::filesystem::path> in_order;
  std::unordered_set<std::string> names;
};

std::mutex mutex;  // guards the files

Files& files() {
  static Files of_this_process;
  return of_this_process;
}

}  // namespace

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

}  // namespace rubsweep::batch
