#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"

namespace rubsweep::linear {

/// Shaft speed W at which two whirl modes can lock to each other through a bouncing contact (Shaw, Champneys
/// and Friswell, Proc. R. Soc. A 472, 2016, 20160303). Whirl frequencies w are positive forward and negative
/// backward; in the rotating frame they are w - W. The modes lock where p (w_first - W) = q (w_second - W),
/// that is, W = (p w_first - q w_second) / (p - q): one mode then whirls p times and the other q times until
/// both meet the wall again at the same place of the shaft.
struct LockSpeed {
  int first = 0, second = 0;  ///< numbers of the modes
  int p = 0, q = 0;
  double speed_hz = 0;
};

/// Lock speeds within a diagram for all pairs of its first four modes and all coprime p > q from 1 to 3,
/// ascending. Modes with more than half of critical damping are left out, because they decay before both
/// modes meet the wall again. Frequencies between the speeds of the diagram come from monotone cubics.
std::vector<LockSpeed> lock_speeds(const Campbell& diagram);

/// Tables of a Campbell diagram as texts. Speeds and frequencies are in Hz.
struct CampbellTables {
  std::string campbell_csv;         ///< speed_hz, mode, whirl, forward_share, frequency_hz, damping_ratio
  std::string critical_speeds_csv;  ///< mode, whirl, speed_hz, damping_ratio
  /// Columns mode, whirl, speed_hz, frequency_hz, position_m, x_real, x_imag, y_real, y_imag; see ModeShape.
  std::string mode_shapes_csv;
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode: see LockSpeed
  std::string summary;          ///< text for a terminal
};

CampbellTables tables_of(const Campbell& diagram);

/// Table of lock speeds with the columns speed_hz, p, first_mode, q, second_mode.
std::string lock_speeds_csv(const std::vector<LockSpeed>& speeds);

}  // namespace rubsweep::linear
