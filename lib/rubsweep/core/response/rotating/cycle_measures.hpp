#pragma once

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// Measures of a motion that is periodic in the rotating frame, z = w(phase) e^{i phase}, from exactly one
/// period of it: the Fourier series of w has its line k at the order 1 + k `comb_spacing` of z, so that the
/// amplitudes are those of an endless record. Lines within half a bin of a window (`window_revolutions`) of
/// 0X or -1X count as these. Hits are those of a window, to the nearest whole number.
motion::Measures measure_cycle(const scene::Scene& scene, const RotatingArc& once,
                               const motion::ResponseOptions& options, motion::Workspace& workspace);

}  // namespace rubsweep::response::rotating
