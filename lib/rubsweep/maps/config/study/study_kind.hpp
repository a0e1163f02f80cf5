#pragma once

#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

/// Reads `study`: the quantity that is determined in every cell in addition to its motion.
void read_study_kind(const yaml::Value& value, sweep::Study& study);

keys::Form study_form();

/// Prints `study`. Prints nothing for a plain map.
void print_study_kind(yaml::Printer& printer, const sweep::Study& study, AxisPrint how);

}  // namespace rubsweep::config::study
