#pragma once

#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::test {

/// Example 03 of NLvib (Krack and Gross, Harmonic Balance for Nonlinear Vibration Problems, 2019): two unit
/// masses in a row on unit springs. The second mass is connected to the ground and driven by 0.1 cos(speed
/// t); the first one meets an elastic stop of stiffness 100 at 1. Proportional damping 0.03 K.
inline scene::Scene two_mass_scene(double speed) {
  scene::Scene scene = one_mass_scene(1, 1, 0, 2 * std::numbers::pi / speed, 1);
  scene.structure.stiffness << 1, -1, -1, 2;
  scene.structure.damping = 0.03 * scene.structure.stiffness;
  scene.structure.points.front().map << 1, 0, 0, 0;
  scene.harmonic_n << 0, 0.1;
  scene.contacts.push_back(wall_across_x(1, 1, 100, 0));
  return scene;
}

}  // namespace rubsweep::test
