#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// Findings in a recording, as tables and as lines for a terminal.
struct ScopeTables {
  /// turn, t_s, speed_hz, x_m, y_m: the section at the mark; centre_x_m, centre_y_m: mean of the turn. One
  /// probe: no y.
  std::string turns_csv;
  std::string
      orbit_csv;  ///< turns, x_m, y_m: the mean period, from the mark on; empty where the speed changes
  std::string lines_csv;  ///< order, amplitude_m, uncertainty_m, phase_deg, phase_uncertainty_deg; likewise.
                          ///< Behind them line_order, line_order_uncertainty, line_amplitude_m,
                          ///< line_amplitude_uncertainty_m: the line whose nearest bin this is, of a motion
                          ///< without a period; else the line itself
  std::string bode_csv;   ///< see waterfall.hpp, as the next one
  std::string waterfall_csv;
  std::string measures_csv;  ///< quantity, value, uncertainty
  std::string summary;
};

/// `verdict` is that of the recording's displacement; `orders`, multiples of 1/8, go into the Bode plot. The
/// summary says lengths as asked for, in um otherwise.
ScopeTables tables_of(const recording::Recording& recording, const Verdict& verdict,
                      const std::vector<double>& orders, const model::ShownLengths& shown = {});

/// The same of a run-up or coast-down (speed_changes), which has no motion that repeats: 1X and, where the
/// speed changes evenly, the mode behind it (linear::fit_ramp_resonance). Needs history_turns.
ScopeTables tables_of_run(const recording::Recording& recording, const std::vector<double>& orders,
                          const model::ShownLengths& shown = {});

}  // namespace rubsweep::scope
