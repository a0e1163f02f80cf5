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

/// One line of a design check.
struct Term {
  std::string check;  ///< word of the column `check`
  std::string place;  ///< empty: of the whole rotor
  std::optional<double> position_m = {}, speed_hz = {}, value = {}, limit = {};
  std::string unit = {};
  std::optional<double> margin = {};  ///< remaining share of the limit; for a separation, share of the speed
  std::optional<bool> met = {};
  std::string not_told = {};  ///< reason why a term with a limit is unknown; else empty
};

/// Input of the lateral analysis of API 617.
struct LateralQuestions {
  SpeedRange operating;
  SpeedRange whole;           ///< speeds up to the maximum continuous speed
  double eccentricity_m = 0;  ///< eccentricity in the case `configured`
  double scale = 1;           ///< factor of the unbalance, for the bearing forces
  double vibration_limit_m = 0;
  std::vector<linear::CriticalSpeed> critical_speeds = {};  ///< within `whole`
  /// true: a free vibration grows, so that no response lasts and no limit counts as met
  bool grows = false;
  std::optional<std::vector<Stage>> stages;  ///< empty: not given; empty list: the rotor does no work
};

/// Highest speeds at which API 617 considers the response and the clearances, as shares of the maximum
/// continuous speed.
inline constexpr double response_up_to = 1.25, trip_speed = 1.05;
inline constexpr double least_decrement = 0.1, least_threshold_ratio = 2;

/// Response to the unbalances of API 617, computed from the full matrices: vibration, amplification factors
/// and separation margins of each case at each probe, and bearing forces. Also logarithmic decrements of
/// Level I and II.
std::vector<Term> lateral_terms(const scene::PreparedMachine& prepared, const LateralQuestions& questions);

/// Highest speed in the tables of the supports, at most `up_to_hz`.
double within_tables_hz(const model::Machine& machine, double up_to_hz);

}  // namespace rubsweep::design
