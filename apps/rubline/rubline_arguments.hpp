#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/analysis/line/follow_line.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"
#include "shared/figure.hpp"
#include "shared/place_arguments.hpp"

namespace rubsweep::apps {

/// Evenly spaced values that include both ends.
struct LineValues {
  double from = 0, to = 0;
  int count = 101;
};

struct RublineArguments : StudyArguments {
  std::string along = {};                 ///< speed_hz, whirl_ratio, eccentricity_m or a key as in --set
  std::optional<LineValues> values = {};  ///< empty: the axis of the configuration's sweep
  PlaceArguments place = {};              ///< fixed speed or unbalance of the line
  std::vector<line::Pass> passes = {};    ///< at least one pass, in the order kick, up, down
  std::optional<Figure> figure = {}, cascade_figure = {};
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
};

/// Reads the command line. Throws UsageError (program.hpp).
RublineArguments parse_rubline_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubline_help();

}  // namespace rubsweep::apps
