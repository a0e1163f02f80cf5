#pragma once

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// The keys of `rotor` beside kind: matrices: those of read_shaft_matrices, and those of a rotor kit that
/// matrices do not exclude. Places along the shaft must be those of nodes.
model::RotorKit read_matrix_rotor(yaml::Section& section);
std::vector<keys::Key> matrix_rotor_keys();

/// Whether a key of a rotor kit is none beside matrices, which stand for it or exclude it.
bool is_excluded_by_matrices(std::string_view name);

/// A problem of each position_m of a map, or of the maps of a list, at which no node of a kit's matrices
/// stands. Without matrices there is none.
void refuse_between_nodes(const yaml::Value& value, const model::RotorKit& kit);

}  // namespace rubsweep::config::machine
