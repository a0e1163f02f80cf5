#pragma once

#include <string>

namespace rubsweep::apps {

/// A cell on the command line; the unbalance is in the measure of the configuration's sweep.
struct CellArgument {
  double speed_hz = 0, unbalance = 0;
};

/// Two numbers from the command line; the axes to which they belong are not known yet.
struct CellValues {
  double first = 0, second = 0;
  bool by_minutes = false;  ///< the first number is a speed in rpm
};

/// Reads X,Y or SPEEDrpm,Y; converts a speed to Hz. Throws UsageError.
CellValues read_cell_values(const std::string& text);

/// The cell with these values as speed and unbalance. Throws UsageError where they are invalid.
CellArgument cell_of(const CellValues& values);

/// Reads SPEED_HZ,UNBALANCE or SPEEDrpm,UNBALANCE. Throws UsageError.
CellArgument read_cell(const std::string& text);

}  // namespace rubsweep::apps
