#pragma once

#include <string>

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/design_terms.hpp"
#include "rubsweep/core/model/length_text.hpp"

namespace rubsweep::design {

/// A design check as one page for a terminal: what is asked, what comes out, `ok` or `NOT MET` where there is
/// a limit. Lengths as asked for, in um otherwise; vibration is peak to peak in any case.
std::string design_page(const DesignCheck& check, const model::ShownLengths& shown = {});

/// A design check as CSV files.
struct DesignTables {
  /// check (vibration, clearance, dry_whip, stability, those of lateral_terms, kick), place (probe or stop
  /// and its number, with the unbalance), position_m, speed_hz, value, limit, unit (m, 1, N, N/m or 1/s),
  /// margin (share of the limit that is left), verdict (ok, not_met, not_told or empty)
  std::string design_check_csv;
  std::string
      unbalance_response_csv;   ///< place, position_m, speed_hz, major_axis_m (scaled, full length), limit_m
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode
  std::string kicks_csv;        ///< speed_hz, force_n (empty: none), motion, runs, failed; empty: none tried
};

DesignTables tables_of(const DesignCheck& check);

}  // namespace rubsweep::design
