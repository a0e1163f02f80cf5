#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Throws ConfigError where writing config.yaml into `directory` would replace the configuration `file` that
/// was read. Files written by a program may be replaced: `written` returns the text of `file` as programs
/// write it, and may throw.
void keep_configuration(const std::filesystem::path& file, const std::filesystem::path& directory,
                        const std::function<std::string()>& written);

/// Calls keep_configuration for the configuration of a run.
void keep_run_configuration(const std::filesystem::path& file, const std::filesystem::path& directory);

/// Directory for the results of a program that computes no map: --output, or the map's directory with this
/// ending. Throws ConfigError where its config.yaml would replace the configuration that was read, or the
/// configuration of a map or of a part of a map.
std::filesystem::path results_directory(const StudyArguments& arguments, const std::filesystem::path& of_map,
                                        std::string_view ending);

}  // namespace rubsweep::apps
