#pragma once

#include <string>

#include "rubsweep/analysis/design/design_check.hpp"

namespace rubsweep::apps {

/// A design check as CSV files.
struct DesignTables {
  /// Columns: check (vibration, clearance, dry_whip, stability, those of lateral_terms, kick), place (probe
  /// or stop with its number, and the unbalance), position_m, speed_hz, value, limit, unit (m, 1, N, N/m or
  /// 1/s), margin (remaining share of the limit), verdict (ok, not_met, not_told or empty).
  std::string design_check_csv;
  std::string
      unbalance_response_csv;   ///< place, position_m, speed_hz, major_axis_m (scaled, full length), limit_m
  std::string lock_speeds_csv;  ///< speed_hz, p, first_mode, q, second_mode
  /// speed_hz, force_n (empty: no rub), motion, runs, failed; empty table: no kicks were tried
  std::string kicks_csv;
};

DesignTables tables_of(const design::DesignCheck& check);

}  // namespace rubsweep::apps
