#pragma once

#include <filesystem>

namespace rubsweep::apps {

/// Refuses a file that could not be written in the end, before anything is computed. Throws IoError
/// "cannot write FILE: ..." where `file` is a directory, a device or a pipe, or where its directory
/// does not let it be written; `makes_directories`: missing directories are made before it is
/// written.
void require_writable(const std::filesystem::path& file, bool makes_directories);

}  // namespace rubsweep::apps
