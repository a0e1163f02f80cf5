#pragma once

#include <array>
#include <string_view>

#include "rubsweep/core/model/shaft_matrices.hpp"

/// Keys of a rotor by matrices, for those that read and that print it.
namespace rubsweep::config::machine {

inline constexpr std::string_view freedoms_key = "degrees_of_freedom", unbalance_key = "unbalance";
inline constexpr std::array<std::string_view, 4> directions{"x", "y", "rx", "ry"};
/// A degree of freedom beside the shaft.
inline constexpr std::string_view no_place = "none";

/// Keys of the place of an unbalance, one of which is given.
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

}  // namespace rubsweep::config::machine
