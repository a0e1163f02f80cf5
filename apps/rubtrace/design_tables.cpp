#include "design_tables.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>
#include <vector>

#include "campbell_tables.hpp"
#include "rubsweep/analysis/design/design_terms.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {
namespace {

using batch::csv_number;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::string_view word_of(const design::Term& term) {
  if (!term.not_told.empty()) return "not_told";
  return !term.met ? "" : *term.met ? "ok" : "not_met";
}

std::string row_of(const design::Term& term) {
  return batch::csv_row(std::vector<std::string>{
             term.check, term.place, csv_number(term.position_m.value_or(nothing)),
             csv_number(term.speed_hz.value_or(nothing)), csv_number(term.value.value_or(nothing)),
             csv_number(term.limit.value_or(nothing)), term.unit, csv_number(term.margin.value_or(nothing)),
             std::string(word_of(term)), term.name}) +
         "\n";
}

std::string design_check_csv(const design::DesignCheck& check) {
  std::string text = "check,place,position_m,speed_hz,value,limit,unit,margin,verdict,name\n";
  for (const design::Term& term : terms_of(check)) text += row_of(term);
  return text;
}

double limit_of(const design::ResponseCurve& curve, double speed_hz, const design::DesignCheck& check) {
  if (!curve.probe) return design::clearance_share * check.clearances[curve.number].diametral_clearance_m;
  return check.operating.contains(speed_hz) ? check.vibration_limit_m : nothing;
}

std::string unbalance_response_csv(const design::DesignCheck& check) {
  std::string text = "place,position_m,speed_hz,major_axis_m,limit_m\n";
  for (const design::ResponseCurve& curve : check.curves) {
    for (std::size_t k = 0; k < curve.speed_hz.size(); ++k) {
      text += fmt::format("{} {},{},{},{},{}\n", curve.probe ? "probe" : "stop", curve.number,
                          csv_number(curve.position_m.value_or(nothing)), csv_number(curve.speed_hz[k]),
                          csv_number(curve.major_axis_m[k]),
                          csv_number(limit_of(curve, curve.speed_hz[k], check)));
    }
  }
  return text;
}

std::string kicks_csv(const design::DesignCheck& check) {
  if (check.kicks.empty()) return {};
  std::string text = "speed_hz,force_n,motion,runs,failed\n";
  for (const design::KickThreshold& kick : check.kicks) {
    text += fmt::format("{},{},{},{},{}\n", csv_number(kick.speed_hz),
                        csv_number(kick.force_n.value_or(nothing)), kick.motion, kick.runs, kick.failed);
  }
  return text;
}

}  // namespace

DesignTables tables_of(const design::DesignCheck& check) {
  return {design_check_csv(check), unbalance_response_csv(check), lock_speeds_csv(check.locks),
          kicks_csv(check)};
}

}  // namespace rubsweep::apps
