#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::apps {

/// Results for a recording, as tables and as text for a terminal.
struct ScopeTables {
  /// Columns turn, t_s, speed_hz, x_m, y_m (the section at the mark), centre_x_m, centre_y_m (mean of the
  /// turn). With one probe the y columns are missing.
  std::string turns_csv;
  std::string
      orbit_csv;  ///< turns, x_m, y_m: the mean period from the mark on; empty where the speed changes
  /// order, amplitude_m, uncertainty_m, phase_deg, phase_uncertainty_deg; empty where the speed changes. Then
  /// line_order, line_order_uncertainty, line_amplitude_m, line_amplitude_uncertainty_m: in a motion without
  /// a period, the line whose nearest bin this is; otherwise the line itself
  std::string lines_csv;
  std::string bode_csv;  ///< this member and the next one: see waterfall.hpp
  std::string waterfall_csv;
  std::string measures_csv;  ///< quantity, value, uncertainty
  std::string summary;
};

/// Makes the tables; `verdict` belongs to the recording's displacement. `orders`: multiples of 1/8 for the
/// Bode plot. `shown`: unit of lengths in the summary, um by default.
ScopeTables tables_of(const recording::Recording& recording, const scope::Verdict& verdict,
                      const std::vector<double>& orders, const model::ShownLengths& shown = {});

/// Tables for a run-up or coast-down (speed_changes), whose motion does not repeat: 1X and, where the speed
/// changes evenly, the mode that causes it (linear::fit_ramp_resonance). Needs at least history_turns turns.
ScopeTables tables_of_run(const recording::Recording& recording, const std::vector<double>& orders,
                          const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
