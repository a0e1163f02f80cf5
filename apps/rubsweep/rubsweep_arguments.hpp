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
  bool fresh = false;                    ///< discard the results of earlier runs
  bool merge = false;                    ///< only merge the results of shards
  std::optional<map::Share> shard = {};  ///< compute only this part
  std::optional<Figure> figure = {};     ///< also draw the finished map
  bool fade = false;                     ///< cells fade with decreasing robust_share
  bool report = false;                   ///< also write report.html of the finished map
  /// Directory whose results are only checked for completeness.
  std::optional<std::filesystem::path> verified = {};
  std::optional<std::string> key_answer = {};  ///< print only this: keys, a schema, or a first configuration
  bool motion_kinds = false;                   ///< print only the table of motions and their colours
  std::optional<std::filesystem::path> status = {};   ///< print only the progress of this directory's map
  std::optional<std::filesystem::path> watched = {};  ///< only show the growing map in this directory
  /// Directory into which only the matrices of the rotor are written.
  std::optional<std::filesystem::path> matrices = {};
};

/// Reads the command line. Throws UsageError (program.hpp).
RubsweepArguments parse_rubsweep_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubsweep_help();

}  // namespace rubsweep::apps
