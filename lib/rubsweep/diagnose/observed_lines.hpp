#pragma once

#include "rubsweep/diagnose/motion_lines.hpp"
#include "rubsweep/diagnose/other_lines.hpp"
#include "rubsweep/diagnose/random_stream.hpp"
#include "rubsweep/diagnose/spread.hpp"

namespace rubsweep::diagnose {

/// How motions are measured, as far as it is known before a recording is looked at.
struct Measuring {
  int probes = 2;  ///< 2: x and y; 1: x alone
  double readings_per_turn = 0;
  Spread noise_share{1e-3, 3e-2,
                     true};  ///< white noise of every reading, standard deviation / size of the motion
  OtherLines other_lines{};  ///< run-out and the like: lines at 1X, 2X, 3X
  double gain_error = 0.02;  ///< standard deviation of each probe's gain about 1
};

/// Lines that an instrument makes of a motion: run-out and lines of other origin, the gains of the probes,
/// and noise, all drawn. One probe stands in a direction that is drawn, too, which comes back in
/// `probe_angle_rad`, from +x to +y.
MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad);

}  // namespace rubsweep::diagnose
