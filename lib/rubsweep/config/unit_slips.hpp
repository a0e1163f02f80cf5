#pragma once

#include <optional>

#include "rubsweep/config/value.hpp"
#include "rubsweep/model/machine.hpp"

namespace rubsweep::config {

/// Refuses numbers that are in range but cannot be meant in the unit of their key: a clearance as large as
/// the radius (millimetres), a kick that lasts a hundred periods of the rotor (milliseconds), a speed a
/// hundred times its natural frequency (revolutions per minute), a hundredfold gravity (millimetres), a rotor
/// that is damped critically or more (per cent). The library itself simulates all of these. `root` is a whole
/// configuration whose values have been read without a problem; what it does not hold is not judged.
void refuse_unit_slips(const Value& root);

/// The largest speed that is not taken for one in revolutions per minute; none of a kit, which has many
/// natural frequencies.
std::optional<double> most_speed_hz(const model::Machine& machine);

}  // namespace rubsweep::config
