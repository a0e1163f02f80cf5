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
  std::optional<std::string> key_answer = {};  ///< answer about configuration keys, printed instead of a run
  /// Directory whose results are only checked for completeness.
  std::optional<std::filesystem::path> verified = {};
};

/// Reads the command line. Throws UsageError (program.hpp).
RingstabArguments parse_ringstab_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string ringstab_help();

}  // namespace rubsweep::apps
