#pragma once

#include <map>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// Complete configuration as YAML, defaults included, that reads back as an equal one. Axes are printed as
/// they were written: by ends and count, and in the unit of the file. Configurations that are written alike
/// give equal bytes. Optional keys without a value (kick, kick.angle_deg, contact_mass_kg) are left out.
/// Matrices of a rotor are printed as texts, or as names of files beside the configuration. Throws
/// ConfigError where the output directory is not UTF-8.
std::string print_config(const RunConfig& config,
                         machine::MatrixPrint matrices = machine::MatrixPrint::inside);

/// Study as YAML with everything that decides the numbers of a map, but without captions and `output`. Axes
/// are printed by their values in SI units, so that equal studies give equal bytes however their files were
/// written.
std::string print_study(const sweep::Study& study);

/// Names of all files that exported_matrices may return.
inline constexpr std::string_view exported_matrix_files[]{
    "mass.mtx",      "stiffness.mtx", "damping.mtx", "gyroscopic.mtx", "degrees_of_freedom.csv",
    "unbalance.csv", "rotor.yaml"};

/// Full finite-element model of the rotor as files by name: the matrices, tables of the degrees of freedom
/// and the unbalance, and rotor.yaml. That is the same configuration with these files in place of the rotor
/// kit, and its results go beside those of the given configuration. Throws ConfigError where matrices cannot
/// represent the rotor, and where an axis of the sweep or the study varies a part of it.
std::map<std::string_view, std::string> exported_matrices(const RunConfig& config);

/// Name-based UUID (version 5, SHA-1) of a text.
std::string digest_of(std::string_view text);

/// Digest of everything that decides the numbers of a map (see print_study): a name-based UUID (version 5,
/// SHA-1). Equal studies have equal digests however their files were written.
std::string study_digest(const sweep::Study& study);

}  // namespace rubsweep::config
