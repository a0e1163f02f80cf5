#pragma once

#include <optional>

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/kick.hpp"

namespace rubsweep::config::study {

/// `kick`: {force_n, duration_s, angle_deg, phase_deg}, the angles optional; and position_m where there are
/// `places` along the shaft of a rotor kit, optional too.
model::Kick read_kick(const yaml::Value& value, const std::optional<model::Range>& places);
/// A kick that no run outlasts leaves nothing to look at: `longest_run_s` is that of the slowest shaft.
void refuse_endless_kick(const yaml::Value& value, const model::Kick& kick, double longest_run_s);

void print_kick(yaml::Printer& printer, const model::Kick& kick);

}  // namespace rubsweep::config::study
