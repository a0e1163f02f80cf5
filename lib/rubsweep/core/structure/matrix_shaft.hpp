#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

constexpr double matrix_rounding =
    1e-9;  ///< share of what stands on the diagonal: numbers count as equal within it

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
  Eigen::VectorXcd kg;               ///< unbalance of the x plane, n numbers, as BeamShaft::unbalance_kg
  std::optional<std::size_t> wrong;  ///< first degree of freedom whose unbalance does not turn with the shaft
};

TurningUnbalance turning_unbalance(const model::ShaftMatrices& matrices, const MatrixLayout& layout);

/// The matrices as a beam shaft: nodes on the shaft by their position, each with deflection and slope, then
/// one coordinate for each pair of directions of the bodies beside it. All stiffness is that of supports and
/// all mass is added mass, plane by plane, so that no bit is lost; a slope that the matrices leave out has a
/// stiffness that nothing bends. Throws ConfigError with the first of problems_of.
BeamShaft matrix_shaft(const model::ShaftMatrices& matrices);

/// The machine with the full finite-element model of its rotor kit as matrices: nodes at all of its parts,
/// stops and sensors and where the kick acts, numbered from 1 on; then pedestals and housings. What its
/// supports and the material of the shaft damp is in the matrices, ratios of modes stay ratios. Supports that
/// follow a table or strike the shaft stay supports beside the matrices. A machine whose rotor has matrices
/// is returned as it is. Throws ConfigError for a Jeffcott rotor, and for what matrices cannot say: a bow,
/// torsion, couplings out of line, and tables of supports at or on a housing.
model::Machine machine_by_matrices(const model::Machine& machine);

}  // namespace rubsweep::structure
