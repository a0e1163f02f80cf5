#pragma once

#include <filesystem>

namespace rubsweep::apps {

/// Refuses, before anything is computed, a file that could not be written in the end. Throws IoError "cannot
/// write FILE: ..." where `file` is a directory, a device or a pipe, or where its directory is not writable.
/// `makes_directories`: missing directories will be made before writing.
void require_writable(const std::filesystem::path& file, bool makes_directories);

}  // namespace rubsweep::apps
