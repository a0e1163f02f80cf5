#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::structure {

constexpr double matrix_rounding =
    1e-9;  ///< of what stands on the diagonal: numbers count as equal within it

/// Degree of freedom behind a coordinate of one plane; the angle about x counts the other way.
struct PlaneSource {
  std::optional<Eigen::Index> freedom;
  double sign = 1;
};

/// The coordinates of a beam shaft and where they come from.
struct MatrixLayout {
  std::vector<double> node_position_m;
  std::array<std::vector<PlaneSource>, 2> plane;  ///< n each
  std::vector<Eigen::Index> bodies;               ///< coordinates beside the shaft

  Eigen::Index coordinates() const { return static_cast<Eigen::Index>(plane[0].size()); }
};

/// All directions of one node by their numbers.
struct MatrixNode {
  std::string name;
  std::optional<double> position_m;
  std::array<std::optional<Eigen::Index>, 4> freedom;

  const std::optional<Eigen::Index>& of(model::Direction direction) const {
    return freedom[static_cast<std::size_t>(direction)];
  }
};

/// Nodes on the shaft by their position, those of one place in the order of the table; then the others.
std::vector<MatrixNode> nodes_of(const model::ShaftMatrices& matrices);

/// Matrices that pass model::validate.
MatrixLayout layout_of(const model::ShaftMatrices& matrices);

/// The block of a matrix between the motions of two planes, n x n: force in plane a by motion in plane b.
Eigen::MatrixXd block(const Eigen::MatrixXd& matrix, const MatrixLayout& layout, std::size_t a,
                      std::size_t b);

struct TurningUnbalance {
  Eigen::VectorXcd kg;               ///< of the x plane, n, as BeamShaft::unbalance_kg
  std::optional<std::size_t> wrong;  ///< first degree of freedom whose unbalance does not turn with the shaft
};

TurningUnbalance turning_unbalance(const model::ShaftMatrices& matrices, const MatrixLayout& layout);

}  // namespace rubsweep::structure
