#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::line {

/// The rotor once per revolution, at the phase of smallest quiet gap.
struct SectionPoint {
  Eigen::Vector2d displacement_m{0, 0}, velocity_m_per_s{0, 0};
};

/// State of all coordinates at that phase, in a form that another cell can start from: velocities per radian
/// of shaft rotation, so that a whirl stays a whirl at another speed.
struct HandedState {
  Eigen::VectorXd displacement_m, velocity_m_per_rad;
};

/// Settled motion of a run, long enough to be drawn.
struct SettledMotion {
  /// One point per turn of the period of a periodic motion; one of a rotor at rest; else two windows.
  std::vector<SectionPoint> section;
  response::spectrum::FullSpectrum spectrum;  ///< over the window that a map takes
  HandedState end;                            ///< after all of it
};

/// Lets `run`, the verdict on `cell`, go on from its last revolution and records it: a rotor that is proven
/// to rest from its closed form; a periodic motion from where its section returns within 1e-5 clearances
/// (after max_revolutions at the latest); a proven motion without a period one window later; any other at
/// once. Empty where the run failed or fails.
std::optional<SettledMotion> settled_motion(const scene::Cell& cell, const response::SettledRun& run,
                                            const sweep::Study& study,
                                            response::motion::Workspace& workspace);

}  // namespace rubsweep::line
