#pragma once

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

model::Friction read_friction(const yaml::Value& value);  ///< Reads `friction` of a stop: a map, or `none`.
keys::Form friction_form();
void print_friction(yaml::Printer& printer, const model::Friction& friction);

}  // namespace rubsweep::config::machine
