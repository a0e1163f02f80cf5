#pragma once

#include <optional>
#include <string>

#include "shared/action.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

struct RubbranchArguments : StudyArguments {
  std::filesystem::path map = {};  ///< a finished map, all of whose families are followed; empty: one cell is
  int threads = 0;                 ///< number of threads for a map
  bool fresh = false;              ///< true: forget what an interrupted call found, for a map
  CellValues cell_values = {};     ///< values that --cell gives
  CellArgument cell = {};          ///< their meaning on the axes of the configuration
  std::string along = {};          ///< speed_hz, whirl_ratio, eccentricity_m or a key as --set names it
  std::optional<double> from = {}, to = {};
  std::string curve = {};  ///< second parameter, named as `along`; empty: no curves in two parameters
  std::optional<double> curve_from = {}, curve_to = {};
  bool switch_at_doublings = false;
  int most_points = 0;  ///< limit on each side of the cell
};

/// Throws UsageError (program.hpp).
RubbranchArguments parse_rubbranch_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubbranch_help();

}  // namespace rubsweep::apps
