#pragma once

#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"

namespace rubsweep::apps {

struct RubdataArguments : StudyArguments {
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
};

/// Reads the command line. Throws UsageError (program.hpp).
RubdataArguments parse_rubdata_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubdata_help();

}  // namespace rubsweep::apps
