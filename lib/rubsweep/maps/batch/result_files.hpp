#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::batch {

/// Texts by file name; tables without the head that all tables have.
using ResultFiles = std::map<std::string_view, std::string>;

/// Program that wrote some results, and the study that they belong to.
struct ResultSource {
  std::string program;  ///< without its version
  std::string digest;
  std::string captions{};              ///< as caption_lines gives them
  std::vector<std::string> made_of{};  ///< names of files in the same directory that the results are made of
};

/// Replaces the files `names` of a directory, all that a run may leave there, by those of a new run: a file
/// of `names` without a text is removed. A directory never mixes two runs, wherever the process or the power
/// ends: all new files are on the disk before the first of the old ones goes, and all old ones are gone
/// before the first new one has its name. Throws IoError.
void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const std::filesystem::path& directory, const ResultSource& source);

/// Removes the existing files of `names`, on the disk as well, and temporaries that killed processes left for
/// these names. Throws IoError.
void remove_result_files(std::span<const std::string_view> names, const std::filesystem::path& directory);

/// The head of a table of such results that grows, and so has no checksum.
std::string growing_table_head(const ResultSource& source);

/// "files     DIRECTORY: NAME NAME" and a line end.
std::string files_line(const ResultFiles& files, const std::filesystem::path& directory);

/// The directory of another result of the study whose map goes into `map`: results/map and results/map/ to
/// results/map_trace.
std::filesystem::path directory_beside(const std::filesystem::path& map, std::string_view ending);

}  // namespace rubsweep::batch
