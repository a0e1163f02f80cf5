#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"
#include "shared/cell_argument.hpp"
#include "shared/figure.hpp"
#include "slice_plane.hpp"

namespace rubsweep::apps {

struct RubbasinArguments : StudyArguments {
  CellArgument cell = {};
  std::optional<std::array<StartNumber, 2>> plane = {};     ///< empty: along the first stop's normal
  std::optional<std::array<double, 2>> from = {}, to = {};  ///< corners of the slice: both or none
  std::array<std::size_t, 2> starts = {65, 65};             ///< numbers, horizontally and vertically
  bool fresh = false;
  std::optional<Figure> figure = {};
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
};

/// Reads the command line. Throws UsageError (program.hpp).
RubbasinArguments parse_rubbasin_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubbasin_help();

}  // namespace rubsweep::apps
