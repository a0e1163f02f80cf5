#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Place of a cell or a line of cells, as far as the command line gives it.
struct PlaceArguments {
  std::optional<double> speed_hz = {};
  std::optional<scene::Unbalance> unbalance = {};
  std::optional<double> unbalance_g_mm = {};  ///< instead, by the mass of the rotor

  bool by_minutes = false;  ///< the speed was said in revolutions per minute

  bool has_unbalance() const { return unbalance || unbalance_g_mm; }
};

/// How the options of an unbalance are listed where one is missing.
inline constexpr std::string_view unbalance_options =
    "--whirl-ratio U, --eccentricity-m E or --unbalance-g-mm G";

/// --speed-hz or --speed-rpm, and --whirl-ratio, --eccentricity-m or --unbalance-g-mm.
void add_place(po::options_description& options);

/// Throws UsageError, also where one quantity is given twice.
PlaceArguments read_place(const po::variables_map& given);

/// The unbalance of a place that has one, for a rotor (see model/balance.hpp). Throws UsageError where none
/// of its discs stands off the axis.
scene::Unbalance unbalance_of(const PlaceArguments& place, const model::Machine& machine);

/// Keeps the units of the command line, so that results are shown in them as well.
void keep_units(const PlaceArguments& place, sweep::Study& study);

/// Throws UsageError where a configuration of this machine could not have this speed, which `option` gave.
void require_speed(std::string_view option, double speed_hz, const model::Machine& machine);

/// Asks about an unlikely unbalance on the command line.
void ask_about(std::string_view program, const scene::Unbalance& unbalance, const model::Machine& machine,
               bool quiet);

}  // namespace rubsweep::apps
