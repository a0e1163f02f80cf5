#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

inline constexpr std::size_t max_stops = 16;

/// Reads the list `stops`. `places`: allowed range of positions along the shaft of a rotor kit, in m. With it
/// position_m is required, without it position_m is an unknown key.
std::vector<model::Stop> read_stops(const yaml::Value& value, const std::optional<model::Range>& places,
                                    std::vector<std::string>& names);
keys::Form stops_form();
void print_stops(yaml::Printer& printer, const std::vector<model::Stop>& stops,
                 const std::vector<std::string>& names);

model::Friction read_friction(const yaml::Value& value);  ///< Reads `friction` of a stop: a map, or `none`.
keys::Form friction_form();
void print_friction(yaml::Printer& printer, const model::Friction& friction);

}  // namespace rubsweep::config::machine
