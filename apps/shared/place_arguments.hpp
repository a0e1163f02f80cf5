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
  std::optional<double> unbalance_g_mm = {};  ///< unbalance in g mm instead; divided by the mass later

  bool by_minutes = false;  ///< the speed was given in rpm

  bool has_unbalance() const { return unbalance || unbalance_g_mm; }
};

/// Names of the unbalance options in messages about a missing one.
inline constexpr std::string_view unbalance_options =
    "--whirl-ratio U, --eccentricity-m E or --unbalance-g-mm G";

/// Adds --speed-hz and --speed-rpm, and --whirl-ratio, --eccentricity-m and --unbalance-g-mm.
void add_place(po::options_description& options);

/// Reads these options. Throws UsageError, also where a quantity is given twice.
PlaceArguments read_place(const po::variables_map& given);

/// The unbalance of a place that has one, converted for the rotor (see model/balance.hpp). Throws UsageError
/// where no disc of the rotor has an eccentricity.
scene::Unbalance unbalance_of(const PlaceArguments& place, const model::Machine& machine);

/// Stores the units of the command line in the study, so that results are shown in these units, too.
void keep_units(const PlaceArguments& place, sweep::Study& study);

/// Throws UsageError where this machine does not allow this speed, which `option` gave.
void require_speed(std::string_view option, double speed_hz, const model::Machine& machine);

/// Prints a question about an unlikely unbalance on the command line.
void ask_about(std::string_view program, const scene::Unbalance& unbalance, const model::Machine& machine,
               bool quiet);

}  // namespace rubsweep::apps
