#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "shared/action.hpp"
#include "shared/figure.hpp"

namespace rubsweep::apps {

struct RubsweepArguments : StudyArguments {
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool fresh = false;                    ///< forget what earlier runs finished
  bool merge = false;                    ///< only put together what shards finished
  std::optional<map::Share> shard = {};  ///< compute this part alone
  std::optional<Figure> figure = {};     ///< also draw the finished map
  bool fade = false;                     ///< true: cells fade by their robust_share
  bool report = false;                   ///< also make report.html of the finished map
  /// Directory whose results are only to be checked for completeness.
  std::optional<std::filesystem::path> verified = {};
  std::optional<std::string> key_answer =
      {};                     ///< only print this: keys, a schema, a configuration to begin with
  bool motion_kinds = false;  ///< only print the table of motions and their colours
  std::optional<std::filesystem::path> status = {};   ///< only say how far the map in this directory is
  std::optional<std::filesystem::path> watched = {};  ///< only show the map in this directory as it grows
  /// Directory that only gets the matrices of the rotor.
  std::optional<std::filesystem::path> matrices = {};
};

/// Throws UsageError (program.hpp).
RubsweepArguments parse_rubsweep_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubsweep_help();

}  // namespace rubsweep::apps
