#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Square matrix of real numbers, full or sparse, that the bytes of a MATLAB file (version 4, 5 or
/// 7.3) hold under a name. What cannot be had is a problem of `value`, and the result is empty.
std::optional<Eigen::MatrixXd> read_matlab_matrix(std::string_view bytes, const std::string& variable,
                                                  const yaml::Value& value);

}  // namespace rubsweep::config::machine
