#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Square matrix of real numbers, full or sparse, that a MATLAB file (version 4, 5 or 7.3) holds under a
/// name. What cannot be had is a problem of `value`, and the result is empty.
std::optional<Eigen::MatrixXd> read_matlab_matrix(const std::filesystem::path& file,
                                                  const std::string& variable, const yaml::Value& value);

}  // namespace rubsweep::config::machine
