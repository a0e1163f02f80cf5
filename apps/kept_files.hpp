#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "command_line.hpp"

namespace rubsweep::apps {

/// Throws ConfigError where the config.yaml that is about to be written into `directory` would take the place
/// of the configuration `file` that was read, unless that is what a program wrote itself: `written` gives the
/// text of that file as programs write it, and may throw.
void keep_configuration(const std::filesystem::path& file, const std::filesystem::path& directory,
                        const std::function<std::string()>& written);

/// The same for the configuration of a run.
void keep_run_configuration(const std::filesystem::path& file, const std::filesystem::path& directory);

/// Where a program that computes no map writes its results: --output, or beside the map's directory with this
/// ending. Throws ConfigError where their config.yaml would take the place of the configuration that was
/// read, or of that of a map or a part of one.
std::filesystem::path results_directory(const StudyArguments& arguments, const std::filesystem::path& of_map,
                                        std::string_view ending);

}  // namespace rubsweep::apps
