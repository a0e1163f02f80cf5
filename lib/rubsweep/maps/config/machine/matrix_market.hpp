#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Reads a square matrix from a text in the Matrix Market format (Boisvert, Pozo, Remington, NISTIR 5935,
/// 1996): coordinate or array, real or integer, general, symmetric (lower triangle) or skew-symmetric
/// (strictly lower triangle). An entry may stand at most once. Reading ends at the first problem, and the
/// result is empty. The problem is reported with the line of the file, or with the line within the text of
/// the configuration.
std::optional<Eigen::MatrixXd> read_matrix_market(const yaml::Value& value);

/// Text that reads back as the same matrix: symmetric or skew-symmetric if the matrix is, and by coordinates
/// or as an array, whichever is shorter.
std::string matrix_market(const Eigen::MatrixXd& matrix);

/// Reads the real square matrix `variable`, full or sparse, from the bytes of a MATLAB file (version 4, 5 or
/// 7.3). Where the matrix cannot be read, a problem of `value` is added and the result is empty.
std::optional<Eigen::MatrixXd> read_matlab_matrix(std::string_view bytes, const std::string& variable,
                                                  const yaml::Value& value);

}  // namespace rubsweep::config::machine
