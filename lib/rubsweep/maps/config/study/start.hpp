#pragma once

#include <optional>

#include "rubsweep/core/model/kick.hpp"
#include "rubsweep/core/model/start.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::study {

/// `kick`; with a position_m where there are `places` along the shaft of a rotor kit.
model::Kick read_kick(const yaml::Value& value, const std::optional<model::Range>& places);
keys::Form kick_form();
/// A kick that no run outlasts leaves nothing to look at: `longest_run_s` is that of the slowest shaft.
void refuse_endless_kick(const yaml::Value& value, const model::Kick& kick, double longest_run_s);

void print_kick(yaml::Printer& printer, const model::Kick& kick);

/// `start`: rest, or a map, of which `{}` starts on the quiet whirl, not kicked.
model::Start read_start(const yaml::Value& value, const std::vector<model::Stop>& stops);
keys::Form start_form();
void print_start(yaml::Printer& printer, const model::Start& start);

}  // namespace rubsweep::config::study
