#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::map {

/// First bytes of a file, enough for the head of a table; empty where there is no regular file.
std::string begin_of(const std::filesystem::path& file);

/// Whether a table says that a program of ours wrote it, by any of the lines of its head.
struct Origin {
  bool ours = false;
  std::string why_not;  ///< "it is not a regular file", "is empty"
};
Origin origin_of(const std::filesystem::path& table);

/// Whether a table in the directory says that this program wrote it.
bool was_written_by(std::string_view program, const std::filesystem::path& directory);

/// Empty where the SHA-256 of a file is one of `sums`, with ends of lines in CR LF or not; otherwise what is
/// wrong. An empty sum says that it is not known: then the file must only be there and not empty.
std::string problem_of(const std::filesystem::path& file, const std::set<std::string>& sums);

/// Verdict on a page of HTML; one without a checksum is looked at only where it is the report of a map.
struct CheckedPage {
  std::string text;
  bool summed = false;  ///< true: the file has a checksum, and so has ours
  std::string problem;
};
CheckedPage check_page_file(const std::filesystem::path& page, bool of_map);

/// Whether kept cases of a diagnosis are as their first line says; empty where they are none.
std::optional<bool> are_cases_whole(const std::filesystem::path& file);

/// Verdict on the recordings that the labels of a set name.
struct CheckedRecordings {
  bool summed = false;  ///< the labels have their checksums
  std::size_t whole = 0;
  std::vector<std::string> faults;
};
CheckedRecordings check_set(const std::filesystem::path& labels);

}  // namespace rubsweep::map
