#include "rubsweep/core/structure/matrix_shaft.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/matrix_layout.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"

namespace rubsweep::structure {
namespace {

/// Frees a matrix that was found symmetric of what rounding has left; one that is keeps its bits.
Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) { return (matrix + matrix.transpose()) / 2; }

void add_node_unbalance(const model::ShaftMatrices& matrices, BeamShaft& shaft) {
  for (const model::NodeUnbalance& one : matrices.unbalance) {
    const auto& all = matrices.degrees_of_freedom;
    const auto at = std::ranges::find(all, one.node, &model::DegreeOfFreedom::node);
    shaft.unbalance_kg(shaft.deflection(at->position_m.value())) +=
        std::polar(one.mass_kg * one.eccentricity_ratio, one.phase_deg * std::numbers::pi / 180);
  }
}

}  // namespace

BeamShaft matrix_shaft(const model::ShaftMatrices& matrices) {
  if (const auto problems = problems_of(matrices); !problems.empty())
    throw ConfigError("rotor." + problems.front().key + ": " + problems.front().wrong +
                      ", allowed: " + problems.front().allowed);
  const MatrixLayout layout = layout_of(matrices);
  const Eigen::Index n = layout.coordinates();
  BeamShaft shaft;
  shaft.node_position_m = layout.node_position_m;
  shaft.mass = shaft.damping = shaft.elastic = Eigen::MatrixXd::Zero(n, n);
  shaft.gyroscopic = symmetric_part(block(matrices.gyroscopic, layout, 0, 1));
  for (std::size_t a = 0; a < 2; ++a) {
    const std::size_t b = 1 - a;
    shaft.added_mass[a] = symmetric_part(block(matrices.mass, layout, a, a));
    shaft.support_stiffness[a][a] = symmetric_part(block(matrices.stiffness, layout, a, a));
    shaft.support_damping[a][a] = symmetric_part(block(matrices.damping, layout, a, a));
    shaft.support_stiffness[a][b] = block(matrices.stiffness, layout, a, b);
    shaft.support_damping[a][b] = block(matrices.damping, layout, a, b);
  }
  const Eigen::VectorXd weight = model::weight_kg(matrices);
  shaft.weight_kg = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const PlaneSource& y = layout.plane[1][static_cast<std::size_t>(k)];
    if (y.freedom) {
      shaft.weight_kg(k) = y.sign * weight(*y.freedom);
    } else {
      for (std::size_t a = 0; a < 2; ++a) shaft.support_stiffness[a][a](k, k) = 1;
    }
  }
  shaft.housings = layout.bodies;
  shaft.unbalance_kg = turning_unbalance(matrices, layout).kg;
  add_node_unbalance(matrices, shaft);
  return shaft;
}

}  // namespace rubsweep::structure
