#pragma once

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/start.hpp"
#include "rubsweep/model/stop.hpp"

namespace rubsweep::config::study {

/// `start`: {x_m, y_m, vx_m_per_s, vy_m_per_s, casings}, each optional; `casings` maps the number of a stop
/// whose casing moves to the same of that casing. `{}` starts on the quiet whirl, not kicked.
model::Start read_start(const yaml::Value& value, const std::vector<model::Stop>& stops);
void print_start(yaml::Printer& printer, const model::Start& start);

}  // namespace rubsweep::config::study
