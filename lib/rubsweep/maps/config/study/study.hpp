#pragma once

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

/// Reads everything of a configuration except `output` from the sections of its root. Leaves Study::with_keys
/// empty.
sweep::Study read_study(yaml::Section& root);
std::vector<keys::Key> study_keys();
keys::Choice kick_or_start();
void print_study(yaml::Printer& printer, const sweep::Study& study, AxisPrint how,
                 machine::MatrixPrint matrices = machine::MatrixPrint::inside);

}  // namespace rubsweep::config::study
