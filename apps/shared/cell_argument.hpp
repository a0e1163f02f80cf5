#pragma once

#include <string>

namespace rubsweep::apps {

/// A cell as the command line names it: the unbalance in the measure of the configuration's sweep.
struct CellArgument {
  double speed_hz = 0, unbalance = 0;
};

/// Two numbers as the command line names them, before it is known of which axes they are values.
struct CellValues {
  double first = 0, second = 0;
  bool by_minutes = false;  ///< the first one is a speed, and was said in revolutions per minute
};

/// Reads X,Y or SPEEDrpm,Y; a speed becomes one in Hz. Throws UsageError.
CellValues read_cell_values(const std::string& text);

/// The cell as speed and unbalance. Throws UsageError where the values are none.
CellArgument cell_of(const CellValues& values);

/// Reads SPEED_HZ,UNBALANCE or SPEEDrpm,UNBALANCE. Throws UsageError.
CellArgument read_cell(const std::string& text);

}  // namespace rubsweep::apps
