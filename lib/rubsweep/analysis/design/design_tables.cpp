#include "rubsweep/analysis/design/design_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "rubsweep/analysis/linear/campbell_tables.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::design {
namespace {

using batch::csv_number;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// One line of the page, as numbers.
struct Line {
  std::string_view check;
  std::string place;
  std::optional<double> position_m{};
  double speed_hz = nothing, value = nothing, limit = nothing;
  std::string_view unit;
  double margin = nothing;
  std::optional<bool> met{};
};

std::string row_of(const Line& line) {
  const std::string_view verdict = !line.met ? "" : *line.met ? "ok" : "not_met";
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", line.check, line.place,
                     csv_number(line.position_m.value_or(nothing)), csv_number(line.speed_hz),
                     csv_number(line.value), csv_number(line.limit), line.unit, csv_number(line.margin),
                     verdict);
}

std::string stop_name(std::size_t stop) { return fmt::format("stop {}", stop); }

std::string design_check_csv(const DesignCheck& check) {
  std::string text = "check,place,position_m,speed_hz,value,limit,unit,margin,verdict\n";
  // The response of a rotor that grows does not last: what it would keep is no verdict.
  const auto if_lasting = [](bool met, const linear::GrowthAt& growth) {
    return !met || growth.growth_per_s == 0 ? std::optional(met) : std::nullopt;
  };
  for (std::size_t k = 0; k < check.probes.size(); ++k) {
    const ProbeResponse& probe = check.probes[k];
    const double margin = 1 - probe.major_axis_m.value / check.vibration_limit_m;
    text += row_of({"vibration", fmt::format("probe {}", k), probe.position_m, probe.major_axis_m.speed_hz,
                    probe.major_axis_m.value, check.vibration_limit_m, "m", margin,
                    if_lasting(margin >= 0, check.growth)});
  }
  for (const ClearanceMargin& one : check.clearances) {
    text += row_of({"clearance", stop_name(one.stop), one.position_m, one.speed_hz, one.major_axis_m,
                    clearance_share * one.diametral_clearance_m, "m",
                    std::isfinite(one.margin) ? one.margin : nothing,
                    if_lasting(one.margin >= 0, check.whole_growth)});
  }
  for (const WhipMargin& one : check.whips) {
    text += row_of({"dry_whip",
                    stop_name(one.stop),
                    {},
                    one.needs ? one.needs->speed_hz : nothing,
                    one.friction,
                    one.needs ? one.needs->least_friction : nothing,
                    "1",
                    one.margin(),
                    one.margin() > 0});
  }
  const bool grows = check.growth.growth_per_s > 0;
  text += row_of({"stability",
                  "",
                  {},
                  grows ? check.growth.speed_hz : nothing,
                  check.growth.growth_per_s,
                  0,
                  "1/s",
                  nothing,
                  !grows});
  if (const KickThreshold* kick = check.smallest_kick(); kick != nullptr)
    text += row_of({"kick", "", {}, kick->speed_hz, *kick->force_n, nothing, "N", nothing, {}});
  return text;
}

double limit_of(const ResponseCurve& curve, double speed_hz, const DesignCheck& check) {
  if (!curve.probe) return clearance_share * check.clearances[curve.number].diametral_clearance_m;
  return check.operating.contains(speed_hz) ? check.vibration_limit_m : nothing;
}

std::string unbalance_response_csv(const DesignCheck& check) {
  std::string text = "place,position_m,speed_hz,major_axis_m,limit_m\n";
  for (const ResponseCurve& curve : check.curves) {
    for (std::size_t k = 0; k < curve.speed_hz.size(); ++k) {
      text += fmt::format("{} {},{},{},{},{}\n", curve.probe ? "probe" : "stop", curve.number,
                          csv_number(curve.position_m.value_or(nothing)), csv_number(curve.speed_hz[k]),
                          csv_number(curve.major_axis_m[k]),
                          csv_number(limit_of(curve, curve.speed_hz[k], check)));
    }
  }
  return text;
}

std::string kicks_csv(const DesignCheck& check) {
  if (check.kicks.empty()) return {};
  std::string text = "speed_hz,force_n,motion,runs,failed\n";
  for (const KickThreshold& kick : check.kicks) {
    text += fmt::format("{},{},{},{},{}\n", csv_number(kick.speed_hz),
                        csv_number(kick.force_n.value_or(nothing)), kick.motion, kick.runs, kick.failed);
  }
  return text;
}

}  // namespace

DesignTables tables_of(const DesignCheck& check) {
  return {design_check_csv(check), unbalance_response_csv(check), linear::lock_speeds_csv(check.locks),
          kicks_csv(check)};
}

}  // namespace rubsweep::design
