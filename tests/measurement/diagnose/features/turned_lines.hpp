#pragma once

#include <cmath>
#include <complex>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose {

/// A motion over 12 turns with subharmonics and without any symmetry.
inline MotionLines crooked_motion() {
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = {1, 0.2};
  lines.at(-12) = {0.3, -0.1};
  lines.at(6) = {0.2, 0.4};
  lines.at(-6) = {-0.1, 0.15};
  lines.at(18) = {0.05, 0.1};
  lines.at(24) = {0.2, -0.05};
  lines.at(-24) = {0.02, 0.1};
  lines.at(36) = {-0.07, 0.03};
  return lines;
}

/// Lines of the motion of `lines`, rotated, scaled, and recorded from another mark.
inline MotionLines seen_otherwise(const MotionLines& lines, double scale, double turn_rad, double mark_rad) {
  MotionLines seen = lines;
  for (int k = -lines.last(); k <= lines.last(); ++k)
    seen.at(k) *= std::polar(scale, turn_rad + k * mark_rad / lines.turns);
  return seen;
}

/// The motion as a single probe reads it.
inline MotionLines one_reading(const MotionLines& lines) {
  MotionLines seen = lines;
  for (int k = -lines.last(); k <= lines.last(); ++k)
    seen.at(k) = (lines.at(k) + std::conj(lines.at(-k))) / 2.0;
  return seen;
}

}  // namespace rubsweep::diagnose
