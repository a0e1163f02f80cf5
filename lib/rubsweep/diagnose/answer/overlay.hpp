#pragma once

#include "rubsweep/diagnose/motion_lines.hpp"

namespace rubsweep::diagnose::answer {

/// A simulated motion laid over a recorded one.
struct Overlay {
  MotionLines simulated{};  ///< scaled, turned and recorded from the same mark, m
  double unexplained = 0;   ///< share of the recorded energy that it leaves, from 0 to 1
};

/// Scales a simulated motion to the size of the recorded one, begins it at the angle of the shaft where both
/// agree best and, of two probes, turns it to where they agree best: largest correlation over 64 begins a
/// turn. Both about their means, of the same number of turns.
Overlay lay_over(const MotionLines& recorded, const MotionLines& simulated, bool plane);

}  // namespace rubsweep::diagnose::answer
