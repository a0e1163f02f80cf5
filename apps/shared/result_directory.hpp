#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace rubsweep::apps {

/// Makes the directory of results before the results are computed, so that a failure costs no computing time.
/// However the program ends, also by Ctrl-C, directories made for it do not remain if they are empty. Only
/// one object at a time.
class ResultDirectory {
 public:
  /// `names`: the files that will be written there. Throws IoError where the directory cannot be made, or
  /// where one of the names exists but is not a file.
  ResultDirectory(const std::filesystem::path& directory, std::span<const std::string_view> names);
  ~ResultDirectory();
  ResultDirectory(const ResultDirectory&) = delete;
  ResultDirectory& operator=(const ResultDirectory&) = delete;
};

/// Removes the directories made by this run that are still empty. May be called by a signal handler.
void remove_empty_result_directories();

}  // namespace rubsweep::apps
