#pragma once

#include "rubsweep/measurement/diagnose/answer/answer.hpp"

namespace rubsweep::diagnose::answer {

/// A motion with lines at 1X and 1/2X over 4 turns.
inline MotionLines small_motion() {
  MotionLines lines{4, Eigen::VectorXcd::Zero(2 * 12 + 1)};
  lines.at(4) = 1e-4;
  lines.at(2) = {0, 5e-5};
  return lines;
}

inline Answer small_answer() {
  Answer answer;
  answer.recording = {.name = "run7.csv", .speed_hz = 70, .turns = 30, .probes = 2, .size_m = 1.1e-4};
  answer.candidates = {{"one_side",
                        Cause::one_side,
                        0.9,
                        {{"clearance_m", 2e-4, 1.5e-4, 3e-4}, {"stop_angle_deg", 90, 80, 101}}},
                       {"annular", Cause::annular, 0.06, {}}};
  answer.none = 0.04;
  answer.p_value = 0.37;
  answer.cases = 3000;
  answer.deciding = {{"energy at 1X", -0.1, -0.2, 0.1, -2, 0.5, 12}};
  answer.best = {{"one_side", lay_over(small_motion(), small_motion(), true)}};
  answer.next = {{"at 77 Hz (4620 rpm)", 0.4}};
  return answer;
}

}  // namespace rubsweep::diagnose::answer
