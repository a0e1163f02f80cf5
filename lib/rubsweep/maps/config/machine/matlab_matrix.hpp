#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Reads the real square matrix `variable`, full or sparse, from the bytes of a MATLAB file (version 4, 5 or
/// 7.3). Where the matrix cannot be read, a problem of `value` is added and the result is empty.
std::optional<Eigen::MatrixXd> read_matlab_matrix(std::string_view bytes, const std::string& variable,
                                                  const yaml::Value& value);

}  // namespace rubsweep::config::machine
