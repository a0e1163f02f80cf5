#pragma once

#include <map>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {

/// Names of all files of exported_matrices.
inline constexpr std::string_view exported_matrix_files[]{
    "mass.mtx",      "stiffness.mtx", "damping.mtx", "gyroscopic.mtx", "degrees_of_freedom.csv",
    "unbalance.csv", "rotor.yaml"};

/// The full finite-element model of the rotor as files by name: matrices, tables of the degrees of freedom
/// and the unbalance, and rotor.yaml, the same configuration with them in place of the rotor kit, its results
/// beside those of the given one. Throws ConfigError where matrices cannot say the rotor, and where an axis
/// of the sweep or the study varies a part of it.
std::map<std::string_view, std::string> exported_matrices(const RunConfig& config);

}  // namespace rubsweep::config
