#pragma once

#include <filesystem>

namespace rubsweep::apps {

/// Shows a map while it is computed, by whichever processes, and what each of these does: on a terminal drawn
/// anew every two seconds until nobody is at work, elsewhere once. Changes nothing in the directory. Throws
/// IoError where it is none.
void watch_map(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
