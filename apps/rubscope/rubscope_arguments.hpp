#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"
#include "shared/cell_argument.hpp"
#include "shared/figure.hpp"
#include "shared/recording_arguments.hpp"

namespace rubsweep::apps {

/// A cell of a configuration; the recording is compared with its motion.
struct ComparedCell {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  CellArgument cell;
};

struct RubscopeArguments : RecordingArguments {
  std::vector<double> orders = {1, 2};  ///< orders of the Bode plot: multiples of 1/8
  scope::Thresholds thresholds = {};
  std::optional<ComparedCell> compared = {};
  model::ShownLengths shown = {};  ///< unit of lengths in the printed text
  std::optional<Figure> figure = {};
  bool columns = false;  ///< only list the contents of the recording
};

/// Reads the command line. Throws UsageError (program.hpp).
RubscopeArguments parse_rubscope_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubscope_help();

}  // namespace rubsweep::apps
