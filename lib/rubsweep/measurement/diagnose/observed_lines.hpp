#pragma once

#include "rubsweep/measurement/diagnose/motion_lines.hpp"
#include "rubsweep/measurement/diagnose/other_lines.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"
#include "rubsweep/measurement/diagnose/spread.hpp"

namespace rubsweep::diagnose {

/// How motions are measured, as far as it is known before a recording is looked at.
struct Measuring {
  int probes = 2;  ///< 2: x and y; 1: in one direction
  double readings_per_turn = 0;
  bool directions = false;  ///< the machine is not the same in all directions, and those of the probes are known
  double probe_angle_rad = 0;  ///< of one probe whose direction is known, from +x to +y
  bool from_rest = false;      ///< readings count from where the rotor rests
  Spread noise_share{1e-3, 3e-2,
                     true};  ///< white noise of every reading, standard deviation / size of the motion
  OtherLines other_lines{};  ///< run-out and the like: lines at 1X, 2X, 3X
  double gain_error = 0.02;  ///< standard deviation of each probe's gain about 1
  /// Standard deviation of the place of rest, in x and in y, over the size of the motion: a shaft rests where
  /// it was left.
  static constexpr double rest_error = 0.02;
};

/// Lines that an instrument makes of a motion: run-out and lines of other origin, the gains of the probes,
/// and noise, all drawn. One probe stands in a direction that is drawn, too, unless it is known, and comes
/// back in `probe_angle_rad`, from +x to +y.
MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad);

}  // namespace rubsweep::diagnose
