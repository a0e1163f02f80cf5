#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "map_directory.hpp"
#include "rubsweep/batch/progress.hpp"

namespace rubsweep::apps {

enum class Action { run, check, explain, print_config, help, version };

struct RubsweepArguments {
  Action action = Action::run;
  std::filesystem::path config;
  std::optional<std::filesystem::path> output;
  int threads = 0;
  std::vector<std::string> overrides;  ///< `key.path=value` of every --set
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
  bool fresh = false;          ///< forget what an interrupted run finished
  bool merge = false;          ///< only put together what shards finished
  std::optional<Share> shard;  ///< compute this part alone
};

/// Throws UsageError (program.hpp).
RubsweepArguments parse_rubsweep_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubsweep_help();

}  // namespace rubsweep::apps
