#pragma once

#include <Eigen/Core>

namespace rubsweep::structure {

/// Impulses that follow the rotation at a fixed ratio: `multiple` per revolution, the first one
/// `phase_periods` of the rotation between two after the start of a run.
struct ImpulseTrain {
  Eigen::VectorXd impulse_ns;  ///< n: generalised impulse; the velocities jump by mass^-1 impulse
  double multiple = 0;         ///< > 0
  double phase_periods = 0;    ///< >= 0 and < 1
};

}  // namespace rubsweep::structure
