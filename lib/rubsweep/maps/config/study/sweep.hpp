#pragma once

#include <array>
#include <string_view>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

inline constexpr std::string_view speed_rpm_key = "speed_rpm", unbalance_key = "unbalance_g_mm",
                                  grade_key = "balance_grade_mm_per_s", rated_hz_key = "rated_speed_hz",
                                  rated_rpm_key = "rated_speed_rpm";
inline constexpr std::array speed_keys{std::string_view("speed_hz"), speed_rpm_key};

/// Reads `speed_hz` or `speed_rpm` of `sweep` into the speeds of `grid`, in Hz.
void read_speeds(yaml::Section& sweep, sweep::Grid& grid);

/// Reads one of `whirl_ratio`, `eccentricity_m`, `unbalance_g_mm` and `balance_grade_mm_per_s` of `sweep`
/// into measure and values of `grid`. The last two are converted to eccentricities, which are the same in all
/// cells. An unbalance is converted with the mass of the rotor (see model/balance.hpp), a grade with the
/// rated speed, `rated_speed_hz` or `rated_speed_rpm`.
void read_unbalance(yaml::Section& sweep, const model::Machine& machine, sweep::Grid& grid);

/// Axes written in revolutions per minute, or in g mm, where `units_per_metre` g mm are 1 m of eccentricity.
sweep::WrittenAxis in_rpm();
sweep::WrittenAxis in_g_mm(double units_per_metre);

/// Key of `sweep` whose values are converted to eccentricities with the mass of the rotor; empty where there
/// is none.
std::string_view key_by_mass(const yaml::Node& sweep, const model::Machine& machine);

inline constexpr std::size_t max_cells = 4'000'000;

/// Reads `sweep` for a machine that has been read: speed and unbalance, each an axis (see axis.hpp) in one of
/// several units, the axes over keys (see axis.hpp), and `refine`: {levels, probes} (see
/// sweep/refinement.hpp).
sweep::Grid read_sweep(const yaml::Value& value, const model::Machine& machine);

keys::Form sweep_form();

/// Prints `sweep` as it was written, or by its values in SI units.
void print_sweep(yaml::Printer& printer, const sweep::Grid& grid, AxisPrint how);

}  // namespace rubsweep::config::study
