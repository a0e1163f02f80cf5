#pragma once

#include <string_view>

#include "map_directory.hpp"
#include "rubsweep/config/run_config.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/sweep/study.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// What is said of the whole map in `directory`, the picture and the page that the arguments ask for, and the
/// exit code, whoever computed the map. `program` is who says it. Throws IoError.
int report_map(std::string_view program, const RubsweepArguments& arguments,
               const report::MapSummary& summary, const config::RunConfig& config, MapDirectory& directory);

/// Throws ConfigError before anything is computed where a picture is to fade by what the map will not have.
void refuse_fading(const RubsweepArguments& arguments, const sweep::Study& study);

}  // namespace rubsweep::apps
