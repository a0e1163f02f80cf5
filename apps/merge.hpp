#pragma once

#include "map_directory.hpp"
#include "rubsweep/config/run_config.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

/// Throws IoError where cells are missing that a whole map has, with the shards whose they are and the
/// commands that compute them. A refined map knows what it still wants only by what it has.
void refuse_to_merge_too_early(const RubsweepArguments& arguments, const config::RunConfig& config,
                               const MapDirectory& directory);

/// `rubsweep CONFIG.yaml` with the options that say which map it is, as a shell takes it, then `more`.
std::string command_of(const RubsweepArguments& arguments, std::string_view more);

}  // namespace rubsweep::apps
