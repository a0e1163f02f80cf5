#pragma once

#include <filesystem>

namespace rubsweep::apps {

/// Shows a map while processes compute it, and what each of them does. On a terminal it is shown again every
/// two seconds until no process works, elsewhere once. Changes nothing in the directory. Throws IoError where
/// it holds no map.
void watch_map(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
