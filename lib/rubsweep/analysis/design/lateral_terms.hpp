#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/analysis/design/damped_stability.hpp"
#include "rubsweep/analysis/design/unbalance_cases.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::design {

/// Reason why a term is unknown although the computed motion meets its limit.
inline constexpr const char* grows_away = "a free vibration grows within the range of speeds";
inline constexpr const char* grows_beyond = "a free vibration grows above the maximum continuous speed";

/// One line of a design check.
struct Term {
  std::string check;  ///< word of the column `check`
  std::string place;  ///< empty: of the whole rotor
  std::optional<double> position_m = {}, speed_hz = {}, value = {}, limit = {};
  std::string unit = {};
  std::optional<double> margin = {};  ///< remaining share of the limit; for a separation, share of the speed
  std::optional<bool> met = {};
  std::string not_told = {};  ///< why nothing is known of a term with a limit; else empty
  std::string name = {};      ///< name that the file of the rotor gives to the place; may be empty
};

/// Input of the lateral analysis of API 617.
struct LateralQuestions {
  SpeedRange operating;
  SpeedRange whole;           ///< speeds up to the maximum continuous speed
  double eccentricity_m = 0;  ///< eccentricity in the case `configured`
  double scale = 1;           ///< factor of the unbalance, for the bearing forces
  double vibration_limit_m = 0;
  std::vector<linear::CriticalSpeed> critical_speeds = {};  ///< up to last_response_hz
  bool grows = false;                        ///< true: a response does not last, so that it keeps no limit
  std::optional<std::vector<Stage>> stages;  ///< empty: not said; none: the rotor does no work
  std::optional<double> decays_to_hz =
      {};  ///< beyond it and beyond `whole` some vibration grows; empty: none
  std::optional<double> gas_density_kg_per_m3 = {};  ///< see region_limit; empty: no region is told
};

/// Highest speeds at which API 617 considers the response and the clearances, as shares of the maximum
/// continuous speed.
inline constexpr double response_up_to = 1.25, trip_speed = 1.05;
inline constexpr double least_decrement = 0.1, least_threshold_ratio = 2;

/// Response to the unbalances of API 617, computed from the full matrices: vibration, amplification factors
/// and separation margins of each case at each probe, and bearing forces. Also logarithmic decrements of
/// Level I and II.
std::vector<Term> lateral_terms(const scene::PreparedMachine& prepared, const LateralQuestions& questions);

/// Term of the whole rotor of which nothing is known, and why.
Term untold(std::string check, std::optional<double> speed_hz, std::string why);

/// Drops the verdict of a limit that is kept only by a response that does not last.
void refuse_verdict(Term& term, const char* why);

/// The speed up to which tables of the supports go, at most `up_to_hz`.
double within_tables_hz(const model::Machine& machine, double up_to_hz);

}  // namespace rubsweep::design
