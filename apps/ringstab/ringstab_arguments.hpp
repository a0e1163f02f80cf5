#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"

namespace rubsweep::apps {

struct RingstabArguments : StudyArguments {
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  std::optional<std::string> key_answer = {};  ///< only print what keys there are
  /// Only say whether the results in this directory are whole.
  std::optional<std::filesystem::path> verified = {};
};

/// Throws UsageError (program.hpp).
RingstabArguments parse_ringstab_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string ringstab_help();

}  // namespace rubsweep::apps
