#pragma once

#include <string>

#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// The complete configuration as YAML, defaults included, that reads back as an equal one: axes as they were
/// written, by ends and count and in the units of the person. Configurations that are written alike give
/// equal bytes. What is optional and has no value of its own (kick, kick.angle_deg, contact_mass_kg) is left
/// out. Matrices of a rotor are written as texts, or as the names of files beside the configuration. Throws
/// ConfigError when the output directory is not UTF-8.
std::string print_config(const RunConfig& config, machine::MatrixPrint matrices = machine::MatrixPrint::inside);

/// Everything that decides the numbers of a map, nothing else: without captions and `output`, and with every
/// axis as its values in SI units, so that equal studies give equal bytes however their files were written.
std::string print_study(const sweep::Study& study);

}  // namespace rubsweep::config
