#pragma once

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// Measures of a motion that is periodic in the rotating frame, z = w(phase) e^{i phase}, from exactly one
/// period. Line k of the Fourier series of w is at the order 1 + k `comb_spacing` of z, so that amplitudes
/// are those of an infinitely long record. Lines within half a bin of a window (`window_revolutions`) of 0X
/// or -1X count as 0X or -1X. Hits are those of a window, rounded.
motion::Measures measure_cycle(const scene::Scene& scene, const RotatingArc& once,
                               const motion::ResponseOptions& options, motion::Workspace& workspace);

}  // namespace rubsweep::response::rotating
