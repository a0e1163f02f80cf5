#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::structure {

/// Problem of matrices that no beam shaft can have.
struct MatrixProblem {
  std::string key;             ///< mass, stiffness, damping, gyroscopic, unbalance or degrees_of_freedom
  std::string wrong, allowed;  ///< finish a sentence about it, and "allowed: "
  std::optional<std::size_t> degree_of_freedom = std::nullopt;  ///< number of the coordinate to blame
};

/// All problems of matrices that pass model::validate: a node with one direction but not its partner in the
/// other plane; a mass that is not symmetric and positive definite, but for degrees of freedom without any,
/// or that couples the planes; a stiffness or damping that is not symmetric within a plane; a gyroscopic
/// matrix that is not skew-symmetric, acts within a plane, or couples two places by one plane more than by
/// the other; an unbalance that does not turn with the shaft. Numbers count as equal within 1e-9 of the
/// diagonal.
std::vector<MatrixProblem> problems_of(const model::ShaftMatrices& matrices);

/// Largest difference between the stiffness matrix and its transpose, and where it stands; 0 where it is
/// symmetric.
struct Asymmetry {
  double difference = 0;
  Eigen::Index row = 0, column = 0;
};
Asymmetry asymmetry_of(const Eigen::MatrixXd& matrix);

}  // namespace rubsweep::structure
