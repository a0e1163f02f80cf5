#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

/// Complex number of a vector in the plane: its length, and its angle from +x towards +y in degrees.
inline std::complex<double> phasor(double amplitude, double phase_deg) {
  return std::polar(amplitude, phase_deg * std::numbers::pi / 180);
}

/// Matrices between the planes: entry [a][b] is the force in plane a by the motion in plane b (0: x, 1: y).
using PlanePairs = std::array<std::array<Eigen::MatrixXd, 2>, 2>;

/// Full finite-element model of a shaft line. A node has (x, y) and the angles of its cross-section
/// (s_x, s_y) = d(x, y)/dz, so that both planes share one set of n coordinates, node by node (w, s), then
/// one per pedestal, then one per housing. With q = q_x + i q_y:
/// mass q'' + (damping - i speed gyroscopic) q' + elastic q = -supports + forces.
struct BeamShaft {
  Eigen::MatrixXd mass;  ///< mass that is the same in both planes
  Eigen::MatrixXd gyroscopic;
  Eigen::MatrixXd damping;  ///< damping of the shaft's own material, in the fixed frame
  Eigen::MatrixXd elastic;  ///< shaft and couplings: what a bow loads
  PlanePairs support_stiffness, support_damping;
  std::array<Eigen::MatrixXd, 2>
      added_mass;                 ///< mass of each plane: point masses, housings, fluid in supports
  Eigen::VectorXcd unbalance_kg;  ///< of the x plane, per metre of eccentricity e: e w^2 Re(unbalance_kg
                                  ///< e^{iwt}); y lags by a quarter turn
  Eigen::VectorXd weight_kg;      ///< share of the mass that gravity pulls along each coordinate of one plane
  double polar_inertia_kg_m2 = 0;
  std::vector<double> node_position_m;                 ///< ascending; twice the same at a coupling
  std::vector<std::optional<Eigen::Index>> pedestals;  ///< coordinate of each support's pedestal
  std::vector<Eigen::Index> housings;                  ///< coordinate of each housing

  Eigen::Index coordinates() const { return mass.rows(); }

  /// Mass of the motion in one plane.
  Eigen::MatrixXd plane_mass(std::size_t plane) const { return mass + added_mass[plane]; }

  /// Stiffness of one plane: the shaft and its supports, without cross terms.
  Eigen::MatrixXd plane_stiffness(std::size_t plane) const {
    return elastic + support_stiffness[plane][plane];
  }

  /// Coordinate of the deflection at a station (its angle is the next one). At a coupling that of the end
  /// before it. Throws SolverError where no node stands.
  Eigen::Index deflection(double position_m) const;
};

/// Mesh and matrices of a valid kit. Nodes stand at the ends of segments, at every part, and at `stations_m`,
/// with elements between them no longer than the shaft's length / kit.elements. Those of a kit with matrices
/// are the nodes of these; throws ConfigError where a part or one of `stations_m` is at none of them.
BeamShaft assemble_beam_shaft(const model::RotorKit& kit, const std::vector<double>& stations_m);

/// Displacement of a support against what it stands on, per coordinate of one plane, n.
Eigen::VectorXd support_gap(const BeamShaft& shaft, const model::RotorKit& kit, std::size_t support);

/// Deflections and angles, n, of the least bent line through given points, which must be nodes: the smallest
/// elastic energy. At least two different positions.
Eigen::VectorXd least_bent_line(const BeamShaft& shaft, const model::BowPoints& points);

}  // namespace rubsweep::structure
