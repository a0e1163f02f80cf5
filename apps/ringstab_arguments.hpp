#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/batch/progress.hpp"

namespace rubsweep::apps {

enum class RingstabAction { run, check, explain, print_config, help, version };

struct RingstabArguments {
  RingstabAction action = RingstabAction::run;
  std::filesystem::path config;
  std::optional<std::filesystem::path> output;
  int threads = 0;
  std::vector<std::string> overrides;  ///< `key.path=value` of every --set
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Throws UsageError (program.hpp).
RingstabArguments parse_ringstab_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string ringstab_help();

}  // namespace rubsweep::apps
