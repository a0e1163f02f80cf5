#pragma once

#include <array>
#include <vector>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {

/// One plane before the reduction.
struct StudiedPlane {
  Eigen::MatrixXd mass, stiffness;
  numerics::dense::CholeskyFactors factor;  ///< factor of the stiffness
  PlaneModes modes;                         ///< all that may be kept
  std::vector<Eigen::Index> seen;           ///< numbers of the seen modes in `modes`, ascending
  std::vector<Eigen::Index> beside;         ///< not seen, but may grow
};

/// Whether something in a kit may feed a free vibration: cross stiffness that is not symmetric, damping that
/// turns with the shaft, a damping matrix that is not positive semidefinite at some speed.
bool may_feed_vibrations(const BeamShaft& shaft, const model::RotorKit& kit);

/// Both planes with the modes that the motion may need. A mode is seen where it moves one of `places_m`, and
/// where damping, gyroscopic moments, cross terms or tables couple it with a mode that is seen, however far
/// around. The others can neither be excited from there nor excite. Where something may feed vibrations they
/// may still grow, which is no rest. Throws ConfigError where numbers are too far apart for any mode to be
/// seen or computed.
std::array<StudiedPlane, 2> study_planes(const BeamShaft& shaft, const model::RotorKit& kit,
                                         const std::vector<double>& places_m);

}  // namespace rubsweep::structure
