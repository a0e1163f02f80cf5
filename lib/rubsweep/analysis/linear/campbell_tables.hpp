#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"

namespace rubsweep::linear {

/// Shaft speed at which two whirl modes can lock to each other through a contact that bounces. Whirl
/// frequencies count positive forward, negative backward. Seen from the turning shaft they are w - W; where p
/// (w_first - W) = q (w_second - W), W = (p w_first - q w_second) / (p - q), one whirls p and the other q
/// times before both meet the wall again at one place of the shaft (Shaw, Champneys and Friswell, Proc. R.
/// Soc. A 472, 2016, 20160303).
struct LockSpeed {
  int first = 0, second = 0;  ///< numbers of the modes
  int p = 0, q = 0;
  double speed_hz = 0;
};

/// Lock speeds of all pairs of the first four modes of a diagram for coprime p > q from 1 to 3, ascending,
/// within its speeds. Modes do not count where they are damped by more than half of critical: such a one is
/// gone before it comes round. Frequencies between the speeds of the diagram by monotone cubics.
std::vector<LockSpeed> lock_speeds(const Campbell& diagram);

/// A Campbell diagram as texts. Speeds and frequencies in Hz.
struct CampbellTables {
  std::string campbell_csv;         ///< speed_hz, mode, whirl, forward_share, frequency_hz, damping_ratio
  std::string critical_speeds_csv;  ///< mode, whirl, speed_hz, damping_ratio
  /// mode, whirl, speed_hz, frequency_hz, position_m, then x_real, x_imag, y_real, y_imag: see ModeShape
  std::string mode_shapes_csv;
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode: see LockSpeed
  std::string summary;          ///< text for a terminal
};

CampbellTables tables_of(const Campbell& diagram);

/// speed_hz, p, first_mode, q, second_mode.
std::string lock_speeds_csv(const std::vector<LockSpeed>& speeds);

}  // namespace rubsweep::linear
