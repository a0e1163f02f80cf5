#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"
#include "rubsweep/analysis/linear/lock_speeds.hpp"

namespace rubsweep::apps {

/// Tables of a linear::Campbell diagram as texts. Speeds and frequencies are in Hz.
struct CampbellTables {
  std::string campbell_csv;         ///< speed_hz, mode, whirl, forward_share, frequency_hz, damping_ratio
  std::string critical_speeds_csv;  ///< mode, whirl, speed_hz, damping_ratio
  /// Columns mode, whirl, speed_hz, frequency_hz, position_m, x_real, x_imag, y_real, y_imag; see ModeShape.
  std::string mode_shapes_csv;
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode: see linear::LockSpeed
  std::string summary;          ///< text for a terminal
};

CampbellTables tables_of(const linear::Campbell& diagram);

/// Table of lock speeds with the columns speed_hz, p, first_mode, q, second_mode.
std::string lock_speeds_csv(const std::vector<linear::LockSpeed>& speeds);

}  // namespace rubsweep::apps
