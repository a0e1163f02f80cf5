#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

/// Complex number for a vector in the plane: its length, and its angle from +x towards +y in degrees.
inline std::complex<double> phasor(double amplitude, double phase_deg) {
  return std::polar(amplitude, phase_deg * std::numbers::pi / 180);
}

/// Matrices between the planes: entry [a][b] maps the motion in plane b to the force in plane a (0: x, 1: y).
using PlanePairs = std::array<std::array<Eigen::MatrixXd, 2>, 2>;

/// Full finite-element model of a shaft line. Each node has displacements (x, y) and angles of its
/// cross-section (s_x, s_y) = d(x, y)/dz, so that both planes share one set of n coordinates: node by node
/// (w, s), then one per pedestal, then one per housing. With q = q_x + i q_y:
/// mass q'' + (damping - i speed gyroscopic) q' + elastic q = -supports + forces.
struct BeamShaft {
  Eigen::MatrixXd mass;  ///< mass that is the same in both planes
  Eigen::MatrixXd gyroscopic;
  Eigen::MatrixXd damping;  ///< damping by the shaft's material, in the fixed frame
  Eigen::MatrixXd elastic;  ///< stiffness of shaft and couplings, which a bow loads
  PlanePairs support_stiffness, support_damping;
  std::array<Eigen::MatrixXd, 2>
      added_mass;                 ///< further mass in each plane: point masses, housings, fluid in supports
  Eigen::VectorXcd unbalance_kg;  ///< unbalance in the x plane per metre of eccentricity e: force e w^2
                                  ///< Re(unbalance_kg e^{iwt}); y lags by a quarter turn
  Eigen::VectorXd weight_kg;      ///< mass whose weight acts along each coordinate of one plane
  double polar_inertia_kg_m2 = 0;
  std::vector<double> node_position_m;                 ///< ascending; two equal ones at a coupling
  std::vector<std::optional<Eigen::Index>> pedestals;  ///< coordinate of each support's pedestal
  std::vector<Eigen::Index> housings;                  ///< coordinate of each housing

  Eigen::Index coordinates() const { return mass.rows(); }

  /// Mass matrix of one plane.
  Eigen::MatrixXd plane_mass(std::size_t plane) const { return mass + added_mass[plane]; }

  /// Stiffness of one plane: shaft and supports, without cross-coupling.
  Eigen::MatrixXd plane_stiffness(std::size_t plane) const {
    return elastic + support_stiffness[plane][plane];
  }

  /// Coordinate of the deflection at a station; its angle is the next coordinate. At a coupling, the end
  /// before it is used. Throws SolverError where there is no node.
  Eigen::Index deflection(double position_m) const;
};

/// Mesh and matrices of a valid kit. Nodes are at the ends of segments, at every part, and at `stations_m`;
/// elements between them are no longer than the shaft's length / kit.elements. A kit with matrices has only
/// the nodes of its matrices; throws ConfigError where a part or one of `stations_m` is at none of these
/// nodes.
BeamShaft assemble_beam_shaft(const model::RotorKit& kit, const std::vector<double>& stations_m);

/// Displacement of the shaft or housing at a support relative to the support's base, as a row on the n
/// coordinates of one plane.
Eigen::VectorXd support_gap(const BeamShaft& shaft, const model::RotorKit& kit, std::size_t support);

/// Deflections and angles, n, of the line of smallest elastic energy through given points, which must be
/// nodes. Needs at least two different positions.
Eigen::VectorXd least_bent_line(const BeamShaft& shaft, const model::BowPoints& points);

}  // namespace rubsweep::structure
