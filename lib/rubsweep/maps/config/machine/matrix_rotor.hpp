/// Keys of a rotor given by matrices, shared by the reader and the printer.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

inline constexpr std::string_view freedoms_key = "degrees_of_freedom", unbalance_key = "unbalance";
inline constexpr std::array<std::string_view, 4> directions{"x", "y", "rx", "ry"};
/// Word in place of a position, for a degree of freedom that does not belong to the shaft.
inline constexpr std::string_view no_place = "none";

/// Keys for the place of an unbalance; exactly one must be given.
inline constexpr std::array<std::string_view, 2> node_or_place{"node", "position_m"};

struct MatrixKey {
  std::string_view name, meaning;
  Eigen::MatrixXd model::ShaftMatrices::*matrix;
  bool needed;
};
inline constexpr std::array<MatrixKey, 4> matrix_keys{
    {{"mass", "mass matrix", &model::ShaftMatrices::mass, true},
     {"stiffness", "stiffness matrix", &model::ShaftMatrices::stiffness, true},
     {"damping", "damping matrix", &model::ShaftMatrices::damping, false},
     {"gyroscopic", "gyroscopic matrix per rad/s", &model::ShaftMatrices::gyroscopic, false}}};

/// Reads the keys of `rotor` for kind: matrices: those of read_shaft_matrices, and those of a rotor kit that
/// matrices do not exclude. Positions along the shaft must be positions of nodes.
model::RotorKit read_matrix_rotor(yaml::Section& section);
std::vector<keys::Key> matrix_rotor_keys();

/// Adds a problem for each position_m of a map, or of a list of maps, where the kit's matrices have no node.
/// Does nothing for a kit without matrices.
void refuse_between_nodes(const yaml::Value& value, const model::RotorKit& kit);

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
