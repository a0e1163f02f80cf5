#pragma once

#include "rubsweep/diagnose/features/feature.hpp"
#include "rubsweep/diagnose/motion_lines.hpp"

namespace rubsweep::diagnose::features {

/// Features of the full spectrum: shares of the energy at multiples of the shaft speed, forward and backward,
/// at fractions 1/2 to 1/5 of it and at its other orders, the strongest of these lines, the noise between the
/// lines, and the phases that lines have to each other. Shares are decimal logarithms. `plane`: two probes;
/// else the motion is real. Lines are read through a Hann window, so that those between two whole numbers of
/// periods stay together.
Features line_features(const MotionLines& lines, bool plane);

}  // namespace rubsweep::diagnose::features
