#pragma once

#include <string>

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/core/model/length_text.hpp"

namespace rubsweep::design {

/// Design check as one page for a terminal: questions, results, and `ok` or `NOT MET` for each limit. Lengths
/// are in the unit of `shown`, by default um; vibration is always peak to peak.
std::string design_page(const DesignCheck& check, const model::ShownLengths& shown = {});

/// A design check as CSV files.
struct DesignTables {
  /// Columns check (vibration, clearance, dry_whip, kick), place (probe or stop and its number), position_m,
  /// speed_hz, value, limit, unit (m, 1 or N), margin (share of the limit that is left), verdict (ok, not_met
  /// or empty)
  std::string design_check_csv;
  std::string
      unbalance_response_csv;   ///< place, position_m, speed_hz, major_axis_m (scaled, full length), limit_m
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode
  std::string kicks_csv;        ///< speed_hz, force_n (empty: none), motion, runs, failed; empty: none tried
};

DesignTables tables_of(const DesignCheck& check);

}  // namespace rubsweep::design
