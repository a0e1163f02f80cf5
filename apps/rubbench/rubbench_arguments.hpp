#pragma once

#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "shared/action.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

struct RubbenchArguments : StudyArguments {
  std::vector<CellArgument> cells = {};  ///< empty: one cell is chosen
  std::vector<integrate::run::Stepper> steppers = {};
  std::vector<double> relative_tolerances = {};
  bench::WorkPrecisionOptions work = {};
  std::size_t label_speeds = 12, label_unbalances = 6;  ///< 0 x 0: no labels are compared
  double label_seconds = 5;                             ///< time limit per variant, s
};

/// Reads the command line. Throws UsageError (program.hpp).
RubbenchArguments parse_rubbench_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubbench_help();

}  // namespace rubsweep::apps
