#pragma once

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::structure {

/// The machine with the full finite-element model of its rotor kit as matrices: nodes at all of its parts,
/// stops and sensors and where the kick acts, numbered from 1 on; then pedestals and housings. What its
/// supports and the material of the shaft damp is in the matrices, ratios of modes stay ratios. Supports that
/// follow a table or strike the shaft stay supports beside the matrices. A machine whose rotor has matrices
/// is returned as it is. Throws ConfigError for a Jeffcott rotor, and for what matrices cannot say: a bow,
/// torsion, couplings out of line, and tables of supports at or on a housing.
model::Machine machine_by_matrices(const model::Machine& machine);

}  // namespace rubsweep::structure
