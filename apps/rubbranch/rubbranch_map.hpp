#pragma once

#include "rubbranch_arguments.hpp"

namespace rubsweep::apps {

/// Follows the families of a finished map to their boundaries, writes the files beside the map and prints a
/// summary. Returns an exit code.
int run_on_map(const RubbranchArguments& arguments);

}  // namespace rubsweep::apps
