#pragma once

#include <optional>

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/model/kick.hpp"

namespace rubsweep::config {

/// `kick`: {force_n, duration_s, angle_deg, phase_deg}, the angles optional; and position_m where there are
/// `places` along the shaft of a rotor kit, optional too.
model::Kick read_kick(const Value& value, const std::optional<model::Range>& places);
void print_kick(Printer& printer, const model::Kick& kick);

}  // namespace rubsweep::config
