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

/// Evenly spaced values, both ends included.
struct LineValues {
  double from = 0, to = 0;
  int count = 101;
};

struct RublineArguments : StudyArguments {
  std::string along = {};                 ///< speed_hz, whirl_ratio, eccentricity_m or a key of --set
  std::optional<LineValues> values = {};  ///< empty: the axis of the configuration's sweep
  PlaceArguments place = {};              ///< where the line lies
  std::vector<line::Pass> passes = {};    ///< passes, at least one, in the order kick, up, down
  std::optional<Figure> figure = {}, cascade_figure = {};
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
};

/// Throws UsageError (program.hpp).
RublineArguments parse_rubline_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubline_help();

}  // namespace rubsweep::apps
