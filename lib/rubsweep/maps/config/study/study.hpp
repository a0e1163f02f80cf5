#pragma once

#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

/// Reads everything of a configuration except `output` from the sections of its root. Leaves Study::with_keys
/// empty.
sweep::Study read_study(yaml::Section& root);
std::vector<keys::Key> study_keys();
keys::Choice kick_or_start();
void print_study(yaml::Printer& printer, const sweep::Study& study, AxisPrint how,
                 machine::MatrixPrint matrices = machine::MatrixPrint::inside);

/// Reads `start`: the word rest, or a map. An empty map `{}` starts on the quiet whirl without a kick.
model::Start read_start(const yaml::Value& value, const std::vector<model::Stop>& stops);
keys::Form start_form();
void print_start(yaml::Printer& printer, const model::Start& start);

/// Reads `study`: the quantity that is determined in every cell in addition to its motion.
void read_study_kind(const yaml::Value& value, sweep::Study& study);

keys::Form study_form();

/// Prints `study`. Prints nothing for a plain map.
void print_study_kind(yaml::Printer& printer, const sweep::Study& study, AxisPrint how);

}  // namespace rubsweep::config::study
