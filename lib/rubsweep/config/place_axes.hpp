#pragma once

#include <string_view>

#include "rubsweep/config/section.hpp"
#include "rubsweep/model/machine.hpp"
#include "rubsweep/sweep/grid.hpp"

namespace rubsweep::config {

inline constexpr std::string_view speed_rpm_key = "speed_rpm", unbalance_key = "unbalance_g_mm",
                                  grade_key = "balance_grade_mm_per_s", rated_hz_key = "rated_speed_hz",
                                  rated_rpm_key = "rated_speed_rpm";

inline constexpr double rpm_per_hz = 60;

/// `speed_hz` or `speed_rpm` of `sweep`, in Hz.
std::vector<double> read_speeds(Section& sweep);

/// One of `whirl_ratio`, `eccentricity_m`, `unbalance_g_mm` and `balance_grade_mm_per_s` of `sweep` into
/// measure and values of `grid`. The latter two become eccentricities here and for good: an unbalance by the
/// mass of the rotor (see model/balance.hpp), a grade at the speed that `rated_speed_hz` or `rated_speed_rpm`
/// beside it names, wherever the cell is.
void read_unbalance(Section& sweep, const model::Machine& machine, sweep::Grid& grid);

/// The key of `sweep` whose values follow from the mass of the rotor; empty where none does.
std::string_view key_by_mass(const Node& sweep, const model::Machine& machine);

}  // namespace rubsweep::config
