#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace rubsweep::apps {

/// Texts by file name.
using ResultFiles = std::map<std::string_view, std::string>;

/// Writes each file whole. A directory never mixes two runs: of `names`, what there is no text for goes.
/// Throws IoError.
void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const std::filesystem::path& directory);

/// "files     DIRECTORY: NAME NAME" and a line end.
std::string files_line(const ResultFiles& files, const std::filesystem::path& directory);

/// The directory of another result of the study whose map goes into `map`: results/map and results/map/ to
/// results/map_trace.
std::filesystem::path directory_beside(const std::filesystem::path& map, std::string_view ending);

}  // namespace rubsweep::apps
