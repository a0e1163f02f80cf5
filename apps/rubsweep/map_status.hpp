#pragma once

#include <filesystem>
#include <string>

namespace rubsweep::apps {

/// How far the map in a directory is, for a terminal: finished cells in all and of each shard, who is at
/// work, and how fast each is, watched for two seconds where somebody is. Changes nothing. Throws IoError.
std::string map_status(const std::filesystem::path& directory);

/// Whether a process is at work on the map in a directory. Throws IoError.
bool is_at_work(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
