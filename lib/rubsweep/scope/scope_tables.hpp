#pragma once

#include <string>

#include "rubsweep/recording/recording.hpp"
#include "rubsweep/scope/verdict.hpp"

namespace rubsweep::scope {

/// What was found in a recording, as tables and as lines for a terminal.
struct ScopeTables {
  std::string
      turns_csv;  ///< turn, t_s, speed_hz, x_m, y_m: the section at the mark; of one probe without y_m
  std::string orbit_csv;     ///< turns, x_m, y_m: the mean period, from the mark on
  std::string lines_csv;     ///< order, amplitude_m, uncertainty_m, phase_deg, phase_uncertainty_deg
  std::string measures_csv;  ///< quantity, value, uncertainty
  std::string summary;
};

/// `verdict` is that of the recording's displacement.
ScopeTables tables_of(const recording::Recording& recording, const Verdict& verdict);

}  // namespace rubsweep::scope
