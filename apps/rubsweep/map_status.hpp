#pragma once

#include <filesystem>
#include <string>

namespace rubsweep::apps {

/// Progress of the map in a directory, for a terminal: finished cells in total and per shard, the working
/// processes, and their speed, measured over two seconds where there are any. Changes nothing. Throws
/// IoError.
std::string map_status(const std::filesystem::path& directory);

/// Whether a process works on the map in a directory. Throws IoError.
bool is_at_work(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
