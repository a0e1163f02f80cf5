#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace rubsweep::apps {

/// Throws ConfigError where the config.yaml that is about to be written into `directory` would take the place
/// of the configuration `file` that was read, unless that is what a program wrote itself: `written` gives the
/// text of that file as programs write it, and may throw.
void keep_configuration(const std::filesystem::path& file, const std::filesystem::path& directory,
                        const std::function<std::string()>& written);

/// The same for the configuration of a run.
void keep_run_configuration(const std::filesystem::path& file, const std::filesystem::path& directory);

/// Throws ConfigError where `directory` holds a map: its config.yaml belongs to it.
void keep_map(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
