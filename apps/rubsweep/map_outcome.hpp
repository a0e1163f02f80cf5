#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// Reports the whole map in `directory`, with the picture and the page that the arguments ask for, whoever
/// computed it, and returns the exit code. `program` is who reports. Throws IoError.
int report_map(std::string_view program, const RubsweepArguments& arguments,
               const report::MapSummary& summary, const config::RunConfig& config,
               map::MapDirectory& directory);

/// Throws ConfigError, before anything is computed, where the map will lack the column that a picture fades
/// by.
void refuse_fading(const RubsweepArguments& arguments, const sweep::Study& study);

/// Throws before anything is computed where the page or the picture that is asked for would be refused in the
/// end: ConfigError for a map of more than two axes, IoError for a page that cannot be written, or that no
/// program is there to write.
void refuse_what_cannot_be_shown(const RubsweepArguments& arguments, const sweep::Study& study,
                                 const std::filesystem::path& directory);

}  // namespace rubsweep::apps
