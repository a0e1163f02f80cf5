#pragma once

#include <filesystem>

namespace rubsweep::batch {

/// Waits until the names in a directory are on the disk, after files were renamed, created or removed there.
/// Without it a loss of power may undo any of that, in any order. A file system that cannot do so is left
/// alone. Throws IoError.
void sync_directory(const std::filesystem::path& directory);

/// Creates a directory and those above it where they are missing, on the disk as well. Throws IoError.
void make_directory(const std::filesystem::path& directory);

}  // namespace rubsweep::batch
