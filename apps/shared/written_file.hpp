#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

/// First bytes of a file, enough for the head of a table; empty where it is no regular file.
std::string begin_of(const std::filesystem::path& file);

/// Whether this program or a sister program wrote a table, according to the comment lines at its begin.
struct Origin {
  bool ours = false;
  std::string why_not;  ///< reason if not, such as "it is not a regular file", "is empty"
};
Origin origin_of(const std::filesystem::path& table);

/// Whether a table in the directory names this program in its head.
bool was_written_by(std::string_view program, const std::filesystem::path& directory);

/// Compares the SHA-256 of a file with `sums`, with line ends LF or CR LF. Returns what is wrong, or an empty
/// text if one of the sums agrees. An empty sum means "unknown": the file must then only exist and not be
/// empty.
std::string problem_of(const std::filesystem::path& file, const std::set<std::string>& sums);

/// Verdict on an HTML page. A page without a checksum is checked only if it is the report of a map.
struct CheckedPage {
  std::string text;
  bool summed = false;  ///< true: the file has a checksum, so one of these programs wrote it
  std::string problem;
};
CheckedPage check_page_file(const std::filesystem::path& page, bool of_map);

/// Whether the file of cases that a diagnosis kept is undamaged, as its first line tells; empty for any other
/// file.
std::optional<bool> are_cases_whole(const std::filesystem::path& file);

/// Verdict on the recordings that the table of labels names.
struct CheckedRecordings {
  bool summed = false;  ///< true: the labels contain checksums of the recordings
  std::size_t whole = 0;
  std::vector<std::string> faults;
};
CheckedRecordings check_set(const std::filesystem::path& labels);

}  // namespace rubsweep::apps
