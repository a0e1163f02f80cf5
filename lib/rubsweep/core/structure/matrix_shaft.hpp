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

constexpr double matrix_rounding = 1e-9;  ///< share of the diagonal entries: numbers count as equal within it

/// Degree of freedom that gives a coordinate of one plane; the angle about x has the opposite sign.
struct PlaneSource {
  std::optional<Eigen::Index> freedom;
  double sign = 1;
};

/// The coordinates of a beam shaft and the degrees of freedom from which they come.
struct MatrixLayout {
  std::vector<double> node_position_m;
  std::array<std::vector<PlaneSource>, 2> plane;  ///< n entries per plane
  std::vector<Eigen::Index> bodies;               ///< coordinates of bodies beside the shaft

  Eigen::Index coordinates() const { return static_cast<Eigen::Index>(plane[0].size()); }
};

/// Indices of the degrees of freedom of one node, by direction.
struct MatrixNode {
  std::string name;
  std::optional<double> position_m;
  std::array<std::optional<Eigen::Index>, 4> freedom;

  const std::optional<Eigen::Index>& of(model::Direction direction) const {
    return freedom[static_cast<std::size_t>(direction)];
  }
};

/// Nodes on the shaft by position (at equal positions in the order of the table), then the other nodes.
std::vector<MatrixNode> nodes_of(const model::ShaftMatrices& matrices);

/// Layout for matrices that pass model::validate.
MatrixLayout layout_of(const model::ShaftMatrices& matrices);

/// Block of a matrix between two planes, n x n: force in plane a by motion in plane b.
Eigen::MatrixXd block(const Eigen::MatrixXd& matrix, const MatrixLayout& layout, std::size_t a,
                      std::size_t b);

struct TurningUnbalance {
  Eigen::VectorXcd kg;               ///< unbalance in the x plane, n numbers, as BeamShaft::unbalance_kg
  std::optional<std::size_t> wrong;  ///< first degree of freedom whose unbalance does not turn with the shaft
};

TurningUnbalance turning_unbalance(const model::ShaftMatrices& matrices, const MatrixLayout& layout);

/// The matrices as a beam shaft: nodes on the shaft by position, each with deflection and slope, then one
/// coordinate for each pair of directions of the other bodies. All stiffness is stored as that of supports
/// and all mass as added mass, plane by plane, so that no bit changes. If the matrices lack a slope, it gets
/// a stiffness without coupling. Throws ConfigError with the first of problems_of.
BeamShaft matrix_shaft(const model::ShaftMatrices& matrices);

/// The machine with the full finite-element model of its rotor kit as matrices. Nodes are at all parts,
/// stops, sensors and the kick, numbered from 1; then come pedestals and housings. The matrices include the
/// damping of supports and of the shaft's material; modal damping ratios stay ratios. Supports with a table
/// or a bearing fault stay outside the matrices. A machine whose rotor has matrices is returned unchanged.
/// Throws ConfigError for a Jeffcott rotor and for features that matrices cannot express: a bow, torsion,
/// misaligned couplings, and tables of supports at or on a housing.
model::Machine machine_by_matrices(const model::Machine& machine);

}  // namespace rubsweep::structure
