#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/structure/lateral_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// A rotor kit in all coordinates of its finite elements, x and y side by side: what its reduced models are
/// judged by. Nothing of it comes from a reduced basis: structural damping is that of all modes.
struct FullSystem {
  LateralSystem system;         ///< shapes are the coordinates themselves; without what depends on the speed
  Eigen::MatrixXd circulatory;  ///< as of Assembly
  std::vector<TabledSupport> tables;  ///< supports that follow the speed; `system` holds their middle one
};

FullSystem full_system(const BeamShaft& shaft, const model::RotorKit& kit);

/// mass q'' + damping q' + stiffness q = forces at one speed.
struct SpeedMatrices {
  Eigen::MatrixXd mass, damping, stiffness;
};

/// The matrices at a speed; supports by tables as the matrices hold them (`supports_rad_per_s` empty) or at a
/// speed of their tables.
SpeedMatrices matrices_at(const FullSystem& full, double speed_rad_per_s,
                          std::optional<double> supports_rad_per_s = {});

}  // namespace rubsweep::structure
