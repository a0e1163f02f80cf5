#pragma once

#include <memory>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// Puts the contents of files in place of `rotor.mass`, `stiffness`, `damping` and `gyroscopic: {file:
/// NAME}`, a Matrix Market file or, where NAME ends in .mat, a MATLAB file with `variable: NAME` (the key's
/// name without), and of `rotor.degrees_of_freedom` and `rotor.unbalance: {file: NAME}`, tables. NAME is
/// relative to the file that it stands in. Does nothing where the rotor is not of kind: matrices.
void resolve_matrices(yaml::Node& root, yaml::Diagnostics& diagnostics);

/// The keys of resolve_matrices, after it: each matrix the text of a Matrix Market file; degrees_of_freedom a
/// map of columns node, direction, position_m (empty or none beside the shaft) and, where the mass matrix
/// does not say it, weight_kg; unbalance columns node, direction, real_kg, imaginary_kg, or a list of maps
/// with node or position_m, mass_kg, eccentricity_ratio and phase_deg. Checks them each by itself and
/// together. Null where the degrees of freedom could not be had; after another problem some matrices may be
/// placeholders.
std::shared_ptr<const model::ShaftMatrices> read_shaft_matrices(yaml::Section& section);

}  // namespace rubsweep::config::machine
