#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// Reports the finished map in `directory`, draws its picture and writes its page if the arguments ask for
/// them, and returns the exit code. `program` is the name in messages. Throws IoError.
int report_map(std::string_view program, const RubsweepArguments& arguments,
               const report::MapSummary& summary, const config::RunConfig& config,
               map::MapDirectory& directory);

/// Throws ConfigError, before anything is computed, where the map will lack the column that decides the
/// fading of a picture.
void refuse_fading(const RubsweepArguments& arguments, const sweep::Study& study);

/// Throws, before anything is computed, where the requested page or picture could not be made in the end.
/// ConfigError: the map has more than two axes. IoError: the page cannot be written, or the program that
/// makes it is missing.
void refuse_what_cannot_be_shown(const RubsweepArguments& arguments, const sweep::Study& study,
                                 const std::filesystem::path& directory);

}  // namespace rubsweep::apps
