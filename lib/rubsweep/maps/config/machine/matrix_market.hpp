#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Square matrix of a text in the Matrix Market format (Boisvert, Pozo, Remington, NISTIR 5935, 1996):
/// coordinate or array, real or integer, general, symmetric (lower triangle) or skew-symmetric (strictly
/// lower triangle). Each entry at most once. A problem has the line of the file, or in a text within the
/// configuration the line in its words; the first one ends the reading, and the result is empty.
std::optional<Eigen::MatrixXd> read_matrix_market(const yaml::Value& value);

/// The text that reads back as the same numbers: symmetric or skew-symmetric where the matrix is, by
/// coordinates or, where that is shorter, as an array.
std::string matrix_market(const Eigen::MatrixXd& matrix);

}  // namespace rubsweep::config::machine
