#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/structure/full_system.hpp"

namespace rubsweep::linear {

/// The rotor of a machine without stops, casings and torsion, bending in x and y.
struct FreeRotor {
  structure::FullSystem full;  ///< a kit in all coordinates of its finite elements, nothing reduced
  /// n x n, skew: i q^H spin q is the mass-weighted sum of the squares of the forward whirl less that of the
  /// backward whirl, in units in which q^H mass q is the sum of both.
  Eigen::MatrixXd spin;
  std::vector<double> position_m;  ///< places along the shaft, ascending; of a Jeffcott rotor the disc, at 0
  Eigen::MatrixXd x, y;            ///< positions x n: deflections in metres = row * q
};

/// A kit with its structural damping, its stops among the places along the shaft; a Jeffcott rotor as it is.
/// The machine must be valid. Throws ConfigError where a ratio damps modes that cannot be computed.
FreeRotor free_rotor(const model::Machine& machine);

}  // namespace rubsweep::linear
