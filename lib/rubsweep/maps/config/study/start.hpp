#pragma once

#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {

/// Reads `start`: the word rest, or a map. An empty map `{}` starts on the quiet whirl without a kick.
model::Start read_start(const yaml::Value& value, const std::vector<model::Stop>& stops);
keys::Form start_form();
void print_start(yaml::Printer& printer, const model::Start& start);

}  // namespace rubsweep::config::study
