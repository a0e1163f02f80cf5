#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/design/dry_whip.hpp"
#include "rubsweep/analysis/design/kick_threshold.hpp"
#include "rubsweep/analysis/design/lateral_terms.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/analysis/linear/campbell.hpp"
#include "rubsweep/analysis/linear/campbell_tables.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::design {

/// Largest vibration of the shaft at a probe that API 617 (9th edition) allows, in metres peak to peak:
/// min(25.4, 25.4 sqrt(12000 / N)) micrometres. N in rpm is the maximum continuous speed, here in Hz, > 0.
double vibration_limit_m(double max_continuous_hz);

/// Eccentricity of a cell that stands for the unbalance of an analysis by API 617, in metres: four times the
/// largest residual unbalance 6350 W / N in g mm, with W in kg the mass of the rotor and N in rpm its maximum
/// continuous speed. The unbalance is spread over the discs as the machine has it. Throws ConfigError where
/// no disc stands off the axis.
double analysis_eccentricity_m(const model::Machine& machine, double max_continuous_hz);

/// Factor from the response that was computed to the one that clearances must bear (API 617, 9th edition; API
/// RP 684): limit / response at the probe that moves most within the operating range, at least 1/2 (as ROSS
/// takes these clauses: a rotor that moves more than twice as much as it may is not judged by less than half
/// of its unbalance) and at most 6. Both in metres peak to peak, `response_m` >= 0.
double scale_factor(double limit_m, double response_m);
inline constexpr double smallest_scale_factor = 0.5, largest_scale_factor = 6;

/// Share of the smallest diametral clearance that the major axis may take (API 617, 9th edition; API RP 684).
inline constexpr double clearance_share = 0.75;

/// The tightest speed of one stop.
struct ClearanceMargin {
  std::size_t stop = 0;
  std::optional<double> position_m;  ///< along the shaft; empty: of a Jeffcott rotor
  double speed_hz = 0;               ///< speed at which the margin is smallest
  double major_axis_m = 0;           ///< there, from end to end
  double diametral_clearance_m =
      0;              ///< twice the smallest gap about the rotor's mean position; 0: it rests on the wall
  double margin = 0;  ///< 1 - major axis / (share of the clearance); below 0: too tight
};

/// The margin of each stop, each at the speed from the first to the last of `speeds_hz` that is worst for it.
/// Offsets of the stop and static loads take from its clearance as they do in a cell.
std::vector<ClearanceMargin> clearance_margins(const scene::PreparedMachine& prepared, double eccentricity_m,
                                               std::span<const double> speeds_hz);

/// Questions of a design check.
struct DesignQuestions {
  SpeedRange operating;                  ///< range whose upper end is the maximum continuous speed
  std::optional<double> eccentricity_m;  ///< unbalance before it is scaled; empty: analysis_eccentricity_m
  int kick_speeds = 11;  ///< evenly spaced ones, beside the lock speeds; 0: no kicks are tried
  int threads = 1;       ///< number of threads as in batch::parallel_run
  std::optional<std::vector<Stage>> stages = {};  ///< see LateralQuestions
};

/// Largest response of one probe within the operating range, before it is scaled.
struct ProbeResponse {
  std::optional<double> position_m;  ///< along the shaft; empty: of a Jeffcott rotor
  Largest major_axis_m;              ///< length from end to end
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
  SpeedRange whole;              ///< range from near standstill, or where the tables begin, to the upper end
  double eccentricity_m = 0;     ///< eccentricity before it is scaled
  double vibration_limit_m = 0;  ///< peak to peak
  std::vector<ProbeResponse> probes;
  double scale = 0;                         ///< factor of the eccentricity: what follows is with it
  std::vector<ClearanceMargin> clearances;  ///< margin of each stop, over the whole range
  std::vector<WhipMargin> whips;            ///< margin of each annular stop
  /// Fastest growth of a free vibration within the operating range, and over the whole range; 0: none grows.
  linear::GrowthAt growth, whole_growth;
  std::vector<linear::LockSpeed> locks;  ///< lock speeds in the operating range
  std::vector<KickThreshold> kicks;      ///< ascending by speed
  std::string no_kicks;                  ///< why there are none; else empty
  std::vector<ResponseCurve> curves;     ///< probes first, then stops
  std::vector<Term> lateral;             ///< clearances up to trip speed, then lateral_terms

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
