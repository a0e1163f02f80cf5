#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace rubsweep::apps {

/// The directory of results, made before they are computed, so that one that cannot be had costs nobody
/// hours. Whatever way the program ends, Ctrl-C included, none that was made for it stays behind empty. One
/// at a time.
class ResultDirectory {
 public:
  /// `names`: the files that will be written there. Throws IoError where there can be no such directory, or
  /// one of them is there and no file.
  ResultDirectory(const std::filesystem::path& directory, std::span<const std::string_view> names);
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;
};

/// Removes the directories that were made and are still empty. May be called by a signal handler.
void remove_empty_result_directories();

}  // namespace rubsweep::apps
