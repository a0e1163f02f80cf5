#pragma once

#include <filesystem>
#include <vector>

namespace rubsweep::batch {

/// Remembers that this process put a whole file in place. For any thread.
void note_written_file(const std::filesystem::path& path);

/// Files that this process put in place and that are still there, each once, in the order in which they came.
std::vector<std::filesystem::path> written_files();

}  // namespace rubsweep::batch
