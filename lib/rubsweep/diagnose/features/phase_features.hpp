#pragma once

#include "rubsweep/diagnose/features/feature.hpp"
#include "rubsweep/diagnose/motion_lines.hpp"

namespace rubsweep::diagnose::features {

/// Phases that lines have to each other, as points inside the unit circle: nearer to the middle where the
/// lines are weak. `plane`: two probes; else the motion is real.
Features phase_features(const MotionLines& lines, bool plane);

}  // namespace rubsweep::diagnose::features
