#pragma once

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// Throws IoError where cells of a whole map are missing, with the shards that have them and the commands
/// that compute them. A refined map knows only from its cells which others it needs.
void refuse_to_merge_too_early(const RubsweepArguments& arguments, const config::RunConfig& config,
                               const map::MapDirectory& directory);

/// Command `rubsweep CONFIG.yaml` with the options that select the map, quoted for a shell, then `more`.
std::string command_of(const RubsweepArguments& arguments, std::string_view more);

}  // namespace rubsweep::apps
