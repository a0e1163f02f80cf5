#pragma once

#include <Eigen/Core>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// M X'' + Omega C X' + (K0 - Omega^2 K2) X = F0 + Omega^2 F2, SI. X = (A, B, q of every load that has a
/// coordinate), q the tangential deflection of the load's tip. Friction makes all of them asymmetric.
struct Matrices {
  Eigen::MatrixXd mass;         ///< M
  Eigen::MatrixXd rotation;     ///< C: gyroscopic and circulatory terms for Omega = 1 rad/s
  Eigen::MatrixXd stiffness;    ///< K0
  Eigen::MatrixXd softening;    ///< K2
  Eigen::VectorXd force;        ///< F0: by the preload
  Eigen::VectorXd centrifugal;  ///< F2; zero without a radius of the ring

  Eigen::Index coordinates() const { return mass.rows(); }
};

/// How one load follows X, and where its friction acts.
struct LoadMaps {
  Eigen::MatrixXd tip;        ///< 2 x N: X to (u along the load, v across it)
  Eigen::RowVector2d inward;  ///< (u, v) to the inward normal displacement of the tip
  Eigen::VectorXd friction;   ///< N: generalised force of a unit rubbing force on the ring
};

/// The friction arm includes the reaction on the load. `coordinate` of q in X; negative: the load has none.
LoadMaps load_maps(const Ring& ring, const Load& load, Eigen::Index coordinate, Eigen::Index size);

/// Coordinate of every load in X, -1 where it has none.
std::vector<Eigen::Index> load_coordinates(const System& system);

/// Regular at every inclination: with q instead of the beam's own flexure v no tan(alpha) appears; the
/// eigenvalues are those of Appendix A (as corrected, see results/ring_findings.txt) for |alpha| < 90
/// degrees.
Matrices assemble(const System& system);

}  // namespace rubsweep::ring
