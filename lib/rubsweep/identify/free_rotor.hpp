#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/model/machine.hpp"
#include "rubsweep/structure/lateral_system.hpp"
#include "rubsweep/structure/tabled_support.hpp"

namespace rubsweep::identify {

/// The rotor of a machine without stops, casings and torsion, bending in x and y.
struct FreeRotor {
  structure::LateralSystem system;
  Eigen::MatrixXd
      circulatory;  ///< n x n or empty: at a speed w the stiffness is system.stiffness + w circulatory
  std::vector<structure::TabledSupport> tables;  ///< supports that follow the speed
  /// n x n, skew: i q^H spin q is the mass-weighted sum of the squares of the forward whirl less that of the
  /// backward whirl, in units in which q^H mass q is the sum of both.
  Eigen::MatrixXd spin;
  std::vector<double> position_m;  ///< places along the shaft, ascending; of a Jeffcott rotor the disc, at 0
  Eigen::MatrixXd x, y;            ///< positions x n: deflections in metres = row * q
};

/// Most modes of each plane, at rest, that span the motion of a kit.
inline constexpr int most_plane_modes = 24;

/// A kit in the coordinates of its lowest modes at rest, whether or not a stop or a sensor sees them, with
/// its structural damping; for supports that follow the speed also of the static deflection by a force at
/// each, so that the modes come out at all speeds; its stops are among the places along the shaft. A Jeffcott
/// rotor as it is. The machine must be valid. Throws ConfigError where no modes can be computed.
FreeRotor free_rotor(const model::Machine& machine);

/// The rotor with its supports at one speed, without tables.
FreeRotor rotor_at(const FreeRotor& rotor, double speed_hz);

}  // namespace rubsweep::identify
