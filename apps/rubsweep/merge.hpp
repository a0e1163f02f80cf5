#pragma once

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// Throws IoError where cells of a complete map are missing, and names the shards of these cells and the
/// commands that compute them. For a refined map, only its finished cells tell which further cells are
/// needed.
void refuse_to_merge_too_early(const RubsweepArguments& arguments, const config::RunConfig& config,
                               const map::MapDirectory& directory);

/// The command `rubsweep CONFIG.yaml` with the options that select the map, quoted for a shell, followed by
/// `more`.
std::string command_of(const RubsweepArguments& arguments, std::string_view more);

}  // namespace rubsweep::apps
