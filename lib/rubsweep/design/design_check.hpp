#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/design/clearance_margin.hpp"
#include "rubsweep/design/dry_whip.hpp"
#include "rubsweep/design/kick_threshold.hpp"
#include "rubsweep/design/largest_over_speed.hpp"
#include "rubsweep/identify/campbell.hpp"
#include "rubsweep/identify/lock_speeds.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::design {

/// Questions of a design check.
struct DesignQuestions {
  SpeedRange operating;                  ///< its upper end is the maximum continuous speed
  std::optional<double> eccentricity_m;  ///< unbalance before it is scaled; empty: analysis_eccentricity_m
  int kick_speeds = 11;  ///< evenly spaced ones, beside the lock speeds; 0: no kicks are tried
  int threads = 1;       ///< as in batch::parallel_run
};

/// Largest response of one probe within the operating range, before it is scaled.
struct ProbeResponse {
  std::optional<double> position_m;  ///< along the shaft; empty: of a Jeffcott rotor
  Largest major_axis_m;              ///< from end to end
};

/// Dry whip in one stop.
struct WhipMargin {
  std::size_t stop = 0;
  double friction = 0;  ///< the largest coefficient of the stop
  std::optional<DryWhip>
      needs;  ///< the least of 11 speeds of the operating range; empty: none at any friction

  double margin()
      const;  ///< 1 - friction / least friction; 1 where there is no dry whip; below 0: it may whip
};

/// Scaled major axis of one place over the speed, from end to end.
struct ResponseCurve {
  bool probe = false;  ///< else a stop
  std::size_t number = 0;
  std::optional<double> position_m;
  std::vector<double> speed_hz, major_axis_m;
};

/// Answers of a design check. Lengths from end to end are diameters.
struct DesignCheck {
  SpeedRange operating;
  SpeedRange whole;              ///< from near standstill, or where the tables begin, to its upper end
  double eccentricity_m = 0;     ///< before it is scaled
  double vibration_limit_m = 0;  ///< peak to peak
  std::vector<ProbeResponse> probes;
  double scale = 0;                         ///< of the eccentricity: what follows is with it
  std::vector<ClearanceMargin> clearances;  ///< one for each stop, over the whole range
  std::vector<WhipMargin> whips;            ///< one for each annular stop
  /// Fastest growth of a free vibration within the operating range, and over the whole range; 0: none grows.
  identify::GrowthAt growth, whole_growth;
  std::vector<identify::LockSpeed> locks;  ///< in the operating range
  std::vector<KickThreshold> kicks;        ///< ascending by speed
  std::string no_kicks;                    ///< why there are none; else empty
  std::vector<ResponseCurve> curves;       ///< of probes, then of stops

  /// The probe that moves most.
  const ProbeResponse& worst_probe() const;
  /// The kick that starts a rub with the smallest force; null where none does.
  const KickThreshold* smallest_kick() const;
};

/// Speeds from which the unbalance response and the modes are taken: of a machine without tables from a
/// thousandth of the maximum continuous speed.
SpeedRange whole_range(const model::Machine& machine, const SpeedRange& operating);

/// Checks a design, whose machine is `prepared`: the unbalance response, scaled, at probes and stops, dry
/// whip, lock speeds and kicks. Throws ConfigError where a table does not reach a speed, or no disc stands
/// off the axis and no eccentricity is given.
DesignCheck check_design(const sweep::Study& study, const scene::PreparedMachine& prepared,
                         const DesignQuestions& questions);

}  // namespace rubsweep::design
