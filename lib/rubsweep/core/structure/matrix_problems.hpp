#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::structure {

/// Property of given matrices that no shaft model can have.
struct MatrixProblem {
  std::string key;             ///< mass, stiffness, damping, gyroscopic, unbalance or degrees_of_freedom
  std::string wrong, allowed;  ///< text of a message behind the key, and behind "allowed: "
  std::optional<std::size_t> degree_of_freedom = std::nullopt;  ///< index of the coordinate to blame
};

/// All problems of matrices that pass model::validate:
/// - a node that has a direction but not its counterpart in the other plane;
/// - a mass that is not symmetric, couples the planes, or is not positive definite over the coordinates with
/// mass;
/// - a stiffness or damping that is not symmetric within a plane;
/// - a gyroscopic matrix that is not skew-symmetric, acts within a plane, or differs between the planes;
/// - an unbalance that does not turn with the shaft.
/// Numbers count as equal within 1e-9 of the diagonal.
std::vector<MatrixProblem> problems_of(const model::ShaftMatrices& matrices);

/// Largest difference between the stiffness matrix and its transpose, and its row and column; 0 if symmetric.
struct Asymmetry {
  double difference = 0;
  Eigen::Index row = 0, column = 0;
};
Asymmetry asymmetry_of(const Eigen::MatrixXd& matrix);

}  // namespace rubsweep::structure
