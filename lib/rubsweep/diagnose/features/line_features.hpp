#pragma once

#include "rubsweep/diagnose/features/feature.hpp"
#include "rubsweep/diagnose/motion_lines.hpp"

namespace rubsweep::diagnose::features {

/// Features of the full spectrum: shares of the energy at multiples of the shaft speed, forward and backward,
/// at fractions 1/2 to 1/5 of it and at its other orders, the strongest of these lines with its sidebands,
/// and the noise between the lines. Shares are decimal logarithms. `plane`: two probes; else the motion is
/// real.
Features line_features(const MotionLines& lines, bool plane);

}  // namespace rubsweep::diagnose::features
