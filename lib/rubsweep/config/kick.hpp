#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/model/kick.hpp"

namespace rubsweep::config {

/// `kick`: {force_n, duration_s, angle_deg}, the angle optional.
model::Kick read_kick(const Value& value);
void print_kick(Printer& printer, const model::Kick& kick);

}  // namespace rubsweep::config
