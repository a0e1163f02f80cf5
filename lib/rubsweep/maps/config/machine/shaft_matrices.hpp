#pragma once

#include <memory>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// Reads the files that keys of `rotor` name, and puts their contents in place of the names. `mass`,
/// `stiffness`, `damping` and `gyroscopic: {file: NAME}` name a Matrix Market file or, where NAME ends in
/// .mat, a MATLAB file; the default of its `variable: NAME` is the name of the key. `degrees_of_freedom` and
/// `unbalance: {file: NAME}` name tables. NAME is relative to the file that it stands in. Does nothing for
/// other kinds of rotors.
void resolve_matrices(yaml::Node& root, yaml::Diagnostics& diagnostics);

/// Reads the keys that resolve_matrices prepared. Each matrix is the text of a Matrix Market file.
/// `degrees_of_freedom` is a map of the columns node, direction, position_m (empty or none for a degree of
/// freedom that is not on the shaft) and, where it does not follow from the mass matrix, weight_kg.
/// `unbalance` has the columns node, direction, real_kg, imaginary_kg, or is a list of maps with node or
/// position_m, mass_kg, eccentricity_ratio and phase_deg. Checks the keys one by one and all together. Null
/// where the degrees of freedom cannot be read. After any other problem some matrices may be placeholders.
std::shared_ptr<const model::ShaftMatrices> read_shaft_matrices(yaml::Section& section);

}  // namespace rubsweep::config::machine
