#pragma once

#include <string>

namespace rubsweep::apps {

/// A cell as the command line names it: the unbalance in the measure of the configuration's sweep.
struct CellArgument {
  double speed_hz = 0, unbalance = 0;
};

/// Reads SPEED_HZ,UNBALANCE or SPEEDrpm,UNBALANCE. Throws UsageError.
CellArgument read_cell(const std::string& text);

}  // namespace rubsweep::apps
