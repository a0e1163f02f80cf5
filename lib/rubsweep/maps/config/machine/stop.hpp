#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

inline constexpr std::size_t max_stops = 16;

/// `stops`: a list of 1 to max_stops maps, each with kind: one_side and angle_deg, or kind: annular and
/// offset_m; clearance_m, stiffness_n_per_m or hertz, contact_radius_m and one of restitution,
/// restitution_by_rotor_mass, restitution_delivered, damping_ns_per_m; contact_mass_kg, friction and casing
/// are optional. `places`: allowed positions along the shaft of a rotor kit; position_m is then required,
/// else it is unknown.
std::vector<model::Stop> read_stops(const yaml::Value& value, const std::optional<model::Range>& places);
keys::Form stops_form();
void print_stops(yaml::Printer& printer, const std::vector<model::Stop>& stops);

}  // namespace rubsweep::config::machine
