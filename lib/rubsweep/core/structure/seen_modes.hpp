#pragma once

#include <array>
#include <vector>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {

/// Modes of one plane before the reduction.
struct StudiedPlane {
  Eigen::MatrixXd mass, stiffness;
  numerics::dense::CholeskyFactors factor;  ///< factor of the stiffness
  PlaneModes modes;                         ///< all modes that may be kept
  std::vector<Eigen::Index> seen;           ///< indices of the seen modes in `modes`, ascending
  std::vector<Eigen::Index> beside;         ///< indices of modes that are not seen but may grow
};

/// Whether something in a kit may feed energy into a free vibration: unsymmetric cross stiffness, rotating
/// damping, or a damping matrix that is not positive semidefinite at some speed.
bool may_feed_vibrations(const BeamShaft& shaft, const model::RotorKit& kit);

/// Both planes with the modes that the motion may need. A mode is seen if it moves one of `places_m`, or if
/// damping, gyroscopic moments, cross terms or tables couple it with a seen mode, directly or through others.
/// Other modes can neither be excited at these places nor act there, but they may still grow if something
/// feeds energy into them. Throws ConfigError where numbers are too far apart for any mode to be seen or
/// computed.
std::array<StudiedPlane, 2> study_planes(const BeamShaft& shaft, const model::RotorKit& kit,
                                         const std::vector<double>& places_m);

}  // namespace rubsweep::structure
