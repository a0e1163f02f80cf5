#pragma once

#include <optional>
#include <string>

#include "shared/action.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

struct RubbranchArguments : StudyArguments {
  std::filesystem::path map = {};  ///< finished map whose families are all followed; empty: one cell
  int threads = 0;                 ///< number of threads, for a map
  bool fresh = false;              ///< discards results of an interrupted call, for a map
  CellValues cell_values = {};     ///< values given by --cell
  CellArgument cell = {};          ///< cell at these values on the configuration's axes
  std::string along = {};          ///< speed_hz, whirl_ratio, eccentricity_m or a key as in --set
  std::optional<double> from = {}, to = {};
  std::string curve = {};  ///< second parameter, named like `along`; empty: no curves in two parameters
  std::optional<double> curve_from = {}, curve_to = {};
  bool switch_at_doublings = false;
  int most_points = 0;  ///< largest number of points on each side of the cell
};

/// Reads the command line. Throws UsageError (program.hpp).
RubbranchArguments parse_rubbranch_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubbranch_help();

}  // namespace rubsweep::apps
