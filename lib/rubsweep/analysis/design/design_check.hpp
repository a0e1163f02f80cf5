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
#include "rubsweep/analysis/linear/lock_speeds.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::design {

/// Vibration limit of API 617 (9th edition) at a probe, in metres peak to peak: min(25.4, 25.4 sqrt(12000 /
/// N)) micrometres, where N is the maximum continuous speed in rpm. Here the speed is in Hz, > 0.
double vibration_limit_m(double max_continuous_hz);

/// Eccentricity in m of a cell that represents the unbalance of an analysis by API 617: four times the
/// largest residual unbalance 6350 W / N in g mm, with the mass W of the rotor in kg and its maximum
/// continuous speed N in rpm. The machine's distribution of the unbalance over the discs stays the same.
/// Throws ConfigError where no disc has an eccentricity.
double analysis_eccentricity_m(const model::Machine& machine, double max_continuous_hz);

/// Factor from the computed response to the response for which clearances are checked (API 617, 9th edition;
/// API RP 684): limit / response at the probe that moves most in the operating range, at most 6 and at least
/// 1/2. ROSS reads the lower limit into these clauses: a rotor that exceeds the limit more than twofold is
/// still checked with half of its unbalance. Both arguments in metres peak to peak, `response_m` >= 0.
double scale_factor(double limit_m, double response_m);
inline constexpr double smallest_scale_factor = 0.5, largest_scale_factor = 6;

/// Largest major axis as a share of the diametral clearance (API 617, 9th edition; API RP 684).
inline constexpr double clearance_share = 0.75;

/// Margin of one stop at the speed where it is smallest.
struct ClearanceMargin {
  std::size_t stop = 0;
  std::optional<double> position_m;  ///< place along the shaft; empty for a Jeffcott rotor
  double speed_hz = 0;               ///< speed at which the margin is smallest
  double major_axis_m = 0;           ///< full length of the major axis at that speed
  double diametral_clearance_m =
      0;              ///< twice the smallest gap at the rotor's mean position; 0: the rotor rests on the wall
  double margin = 0;  ///< 1 - major axis / (allowed share of the clearance); < 0: too little clearance
};

/// Margin of each stop at its worst speed among `speeds_hz`. Offsets of the stop and static loads reduce the
/// clearance as in a cell.
std::vector<ClearanceMargin> clearance_margins(const scene::PreparedMachine& prepared, double eccentricity_m,
                                               std::span<const double> speeds_hz);

/// Questions of a design check.
struct DesignQuestions {
  SpeedRange operating;                  ///< operating range, which ends at the maximum continuous speed
  std::optional<double> eccentricity_m;  ///< before scaling; empty: analysis_eccentricity_m
  int kick_speeds = 11;  ///< evenly spaced speeds, in addition to the lock speeds; 0: no kicks
  int threads = 1;       ///< number of threads as in batch::parallel_run
  std::optional<std::vector<Stage>> stages = {};  ///< see LateralQuestions
  std::optional<double> gas_density_kg_per_m3 = {};
};

/// Largest response of one probe in the operating range, before scaling.
struct ProbeResponse {
  std::optional<double> position_m;  ///< place along the shaft; empty for a Jeffcott rotor
  Largest major_axis_m;              ///< full length of the major axis
  std::string name = {};             ///< names of the sensors; may be empty
};

/// Margin against dry whip in one stop.
struct WhipMargin {
  std::size_t stop = 0;
  double friction = 0;  ///< the largest coefficient of the stop
  std::optional<DryWhip>
      needs;  ///< smallest value at 11 speeds in the operating range; empty: no whirl at any friction

  double margin()
      const;  ///< 1 - friction / least friction; 1 where dry whip is impossible; < 0: dry whip is possible
};

/// Scaled full major axis at one place, as a function of the speed.
struct ResponseCurve {
  bool probe = false;  ///< true: probe, false: stop
  std::size_t number = 0;
  std::optional<double> position_m;
  std::vector<double> speed_hz, major_axis_m;
};

/// Results of a design check. Lengths of major axes are diameters.
struct DesignCheck {
  std::vector<std::string> stop_names;  ///< names of the stops in the study
  SpeedRange operating;
  SpeedRange whole;  ///< range from near standstill, or from the begin of the tables, to its upper end
  double eccentricity_m = 0;     ///< eccentricity before scaling
  double vibration_limit_m = 0;  ///< peak to peak
  std::vector<ProbeResponse> probes;
  double scale = 0;                         ///< factor of the eccentricity; all members below include it
  std::vector<ClearanceMargin> clearances;  ///< margin of each stop, over the whole range
  std::vector<WhipMargin> whips;            ///< margin of each annular stop
  /// Fastest growth of a free vibration in the operating range and in the whole range; 0 where none grows.
  linear::GrowthAt growth, whole_growth;
  /// Fastest growth beyond the whole range, up to 1.25 times its end or the end of the tables, and the speed
  /// up to which none was found there.
  linear::GrowthAt growth_beyond;
  std::optional<double> decays_to_hz;
  std::vector<linear::LockSpeed> locks;  ///< lock speeds in the operating range
  std::vector<KickThreshold> kicks;      ///< ascending by speed
  std::string no_kicks;                  ///< reason why kicks were not tried; empty if they were
  std::vector<ResponseCurve> curves;     ///< probes first, then stops
  std::vector<Term> lateral;             ///< clearances up to trip speed, then lateral_terms

  const ProbeResponse& worst_probe() const;    ///< Probe with the largest response.
  const KickThreshold* smallest_kick() const;  ///< The smallest kick that starts a rub; null if none does.
};

/// Range of speeds for unbalance response and modes. Without tables the range begins at a thousandth of the
/// maximum continuous speed.
SpeedRange whole_range(const model::Machine& machine, const SpeedRange& operating);

/// Checks the design of a study whose prepared machine is `prepared`: scaled unbalance response at probes and
/// stops, dry whip, lock speeds and kicks. Throws ConfigError where a table does not reach a speed, or where
/// no eccentricity is given and no disc has one.
DesignCheck check_design(const sweep::Study& study, const scene::PreparedMachine& prepared,
                         const DesignQuestions& questions);

}  // namespace rubsweep::design
