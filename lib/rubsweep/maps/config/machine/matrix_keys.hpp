#pragma once

#include <array>
#include <string_view>

#include "rubsweep/core/model/shaft_matrices.hpp"

/// Keys of a rotor by matrices, for those that read and that print it.
namespace rubsweep::config::machine {

inline constexpr std::string_view freedoms_key = "degrees_of_freedom", unbalance_key = "unbalance";
/// A degree of freedom beside the shaft.
inline constexpr std::string_view no_place = "none";

struct MatrixKey {
  std::string_view name;
  Eigen::MatrixXd model::ShaftMatrices::*matrix;
  bool needed;
};
inline constexpr std::array<MatrixKey, 4> matrix_keys{
    {{"mass", &model::ShaftMatrices::mass, true},
     {"stiffness", &model::ShaftMatrices::stiffness, true},
     {"damping", &model::ShaftMatrices::damping, false},
     {"gyroscopic", &model::ShaftMatrices::gyroscopic, false}}};

}  // namespace rubsweep::config::machine
